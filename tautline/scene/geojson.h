// Polygons from GeoJSON (RFC 7946).
#ifndef TAUTLINE_SCENE_GEOJSON_H_
#define TAUTLINE_SCENE_GEOJSON_H_

#include <string>

#include "tautline/base/error.h"
#include "tautline/scene/document.h"
#include "tautline/scene/map_world.h"

namespace tautline {

/// Reads a FeatureCollection, a Feature or a bare geometry. Polygon and MultiPolygon, also inside a
/// GeometryCollection, are obstacles with their holes; other geometries and polygons without an area are skipped and
/// counted (source.skipped_features). Properties of a feature:
///   role   "outline": its polygon is the outline of the world, its holes are obstacles; "ignore": skipped;
///          "obstacle" or absent: an obstacle;
///   type   read when there is no role, as in indoor maps: "building_outline" is the outline, a "door" is skipped;
///   name   the obstacle's name; blanks and '^' become '_', a repeated name gets _2, _3, ...
/// Without an outline it is the bounding box of all polygons grown on each side by 10 % of its larger side.
///
/// Coordinates. A `crs` member that names CRS84 or EPSG:4326 says longitude and latitude; one that names anything
/// else ("planar") says planar coordinates in metres. Without `crs` they are longitude and latitude when all are in
/// range (180, 90) and the polygons span less than half a degree both ways, and planar otherwise. Longitude and
/// latitude are projected to metres east and north of the centre of their bounding box, which `source.origin` holds
/// in degrees, with the WGS84 radii of curvature there: lengths are right to a share of (distance from the centre
/// north or south / 6371 km) tan(latitude), that is 0.014 % at 500 m and 60 degrees. Wider than 5 degrees is refused.
///
/// Errors: kInvalidInput with the line (no polygon at all, two outlines, a ring that crosses itself, a hole outside
/// its polygon, coordinates that are no positions), kUnsupported. O(points log points).
[[nodiscard]] Expected<MapWorld> ReadGeoJson(const Document& document, const std::string& file);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_GEOJSON_H_
