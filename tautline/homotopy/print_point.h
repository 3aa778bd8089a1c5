// Points in the messages of GoogleTest.
#ifndef TAUTLINE_HOMOTOPY_PRINT_POINT_H_
#define TAUTLINE_HOMOTOPY_PRINT_POINT_H_

#include <iomanip>
#include <ostream>

#include "tautline/geometry/point.h"

namespace tautline {

inline void PrintTo(Point p, std::ostream* out) { *out << std::setprecision(17) << '(' << p.x << ", " << p.y << ')'; }

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_PRINT_POINT_H_
