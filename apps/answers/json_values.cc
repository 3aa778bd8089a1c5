#include "apps/answers/json_values.h"

#include <cmath>

namespace tautline {

JsonValues::JsonValues(const FreeSpace& space)
    : names_(NamesOf(space)), per_unit_(std::pow(10.0, std::floor(-std::log10(2 * space.grid)))) {}

double JsonValues::Rounded(double value) const {
  const double scaled = value * per_unit_;
  // Beyond 2^53 there is nothing to round; adding zero turns -0 into 0.
  return std::fabs(scaled) < 9e15 ? std::nearbyint(scaled) / per_unit_ + 0.0 : value;
}

Json JsonValues::Of(Point p) const { return Json::array({Rounded(p.x), Rounded(p.y)}); }

Json JsonValues::Of(std::span<const Point> points) const {
  Json list = Json::array();
  for (const Point p : points) list.push_back(Of(p));
  return list;
}

Json JsonValues::Of(const Word& word) const { return ToStrings(word, names_); }

Json JsonValues::Of(const TautPath& path, const std::string& points_key) const {
  Json value;
  value["word"] = Of(path.word);
  value["length"] = path.length;
  value[points_key] = Of(path.points);
  return value;
}

}  // namespace tautline
