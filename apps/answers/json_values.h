// Library values as JSON.
#ifndef APPS_ANSWERS_JSON_VALUES_H_
#define APPS_ANSWERS_JSON_VALUES_H_

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "tautline/homotopy/rays.h"
#include "tautline/homotopy/taut_path.h"
#include "tautline/scene/free_space.h"

namespace tautline {

using Json = nlohmann::ordered_json;

/// Prints values of one free space: coordinates are rounded to decimals no finer than its grid, so that 3.34 stays
/// 3.34; lengths are not rounded.
class JsonValues {
 public:
  explicit JsonValues(const FreeSpace& space);

  Json Of(Point p) const;
  Json Of(std::span<const Point> points) const;
  Json Of(const Word& word) const;

  /// `word`, `length` and, under `points_key`, the points.
  Json Of(const TautPath& path, const std::string& points_key) const;

 private:
  double Rounded(double value) const;

  std::vector<std::string> names_;
  double per_unit_;  ///< A power of ten; coordinates are multiples of its inverse.
};

}  // namespace tautline

#endif  // APPS_ANSWERS_JSON_VALUES_H_
