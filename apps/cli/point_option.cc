#include "apps/cli/point_option.h"

#include <locale>
#include <sstream>

#include "tautline/scene/number_fault.h"

namespace tautline::cli {

Expected<Point> ParsePoint(const std::string& text, const std::string& option) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  Point p;
  char comma = 0;
  if (stream >> p.x >> comma >> p.y && comma == ',' && stream.eof()) {
    if (const auto fault = PointFault(p)) return tl::unexpected<Error>(Error{fault->code, text + fault->text, option});
    return p;
  }
  return InvalidInput(
      "'" + text + "' is not a point; give two numbers with a comma between, such as " + option + " 2,3.5", option);
}

}  // namespace tautline::cli
