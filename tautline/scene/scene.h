// A scene: everything a user says about a problem, as plain values. The narrow waist between readers and planners.
#ifndef TAUTLINE_SCENE_SCENE_H_
#define TAUTLINE_SCENE_SCENE_H_

#include <optional>
#include <string>
#include <vector>

#include "tautline/geometry/occupancy_grid.h"
#include "tautline/geometry/polygon.h"

namespace tautline {

/// A disc, metres.
struct Circle {
  Point centre;       ///< Where it is.
  double radius = 0;  ///< Positive.

  /// Whether centre and radius are equal.
  friend bool operator==(const Circle&, const Circle&) = default;
};

/// Something that neither robot nor tether may enter: exactly one of `polygon` and `circle`.
struct Obstacle {
  std::string name;                         ///< Unique in the scene. Empty: o1, o2, ... by position.
  std::optional<PolygonWithHoles> polygon;  ///< Metres, either orientation.
  std::optional<Circle> circle;             ///< Becomes a polygon that errs outwards.
  std::optional<Point> representative;      ///< Where its ray starts; strictly inside. Absent: chosen.
  bool from_map = false;                    ///< Traced from a map rather than listed in the scene.
};

/// Where the world came from, when it was read from a map file.
struct MapSource {
  std::string path;                  ///< As given.
  std::string kind;                  ///< "ros", "movingai", "geojson".
  double resolution = 0;             ///< Metres per cell; 0 for GeoJSON.
  int columns = 0;                   ///< Cells; 0 for GeoJSON.
  int rows = 0;                      ///< Cells; 0 for GeoJSON.
  Point origin;                      ///< ROS: pose of the lower left corner. GeoJSON: longitude and latitude of (0, 0).
  double origin_yaw = 0;             ///< ROS, radians.
  bool geographic = false;           ///< GeoJSON in longitude and latitude, projected to local metres.
  std::size_t free_cells = 0;        ///< Cells that the map calls free.
  std::size_t blocked_cells = 0;     ///< Cells that the map calls blocked.
  std::size_t unknown_cells = 0;     ///< ROS: counted as blocked unless asked otherwise.
  double simplify = 0;               ///< The tolerance of --simplify, metres; 0: exact cell boundaries.
  std::size_t skipped_features = 0;  ///< GeoJSON: geometries that are no polygons or say that they are to be ignored.
};

/// The ground: an outline and what stands in it.
struct World {
  Ring outline;                     ///< Around the free space; the rectangle of the map for a map of cells. Empty for
                                    ///< a scene without a world (a fleet alone in the plane).
  std::vector<Obstacle> obstacles;  ///< Those of the scene in order, then those traced from the map.
  double clearance = 0;             ///< Metres by which every wall and obstacle grows.
  double snap = 1e-6;               ///< Metres below which boundaries are joined; every such merge is reported.
  std::optional<MapSource> map;     ///< Where it came from, when from a map.
  std::optional<OccupancyGrid> cells;  ///< Of a map of cells, unknown cells as they stand in the map.
};

/// One tethered robot.
struct Tether {
  Point base;                    ///< Where it is tied.
  double length = 0;             ///< Metres.
  std::optional<Polyline> laid;  ///< The cable as it lies, base first, robot last; absent: the robot is at the base.
};

/// What the one tethered robot is like, for planners that need more than a point.
struct RobotBody {
  std::optional<double> radius;   ///< Of its disc, metres; positive.
  std::optional<double> heading;  ///< Where it looks now, radians, counter-clockwise from the x axis.
};

/// A robot moved by several cables.
struct Cables {
  std::vector<Point> anchors;                 ///< Control points in order around the outline.
  std::optional<std::vector<Polyline>> laid;  ///< One polyline per anchor, robot first, anchor last.
  /// Instead of laid cables: one word per anchor, that of the boundary from it to the next one, as ParseWord reads it.
  std::optional<std::vector<std::string>> words;
};

/// A way that an obstacle may move on.
struct ObstacleMove {
  std::string obstacle;  ///< By its name.
  Polyline path;         ///< Of its representative point, from where it is now.
};

/// One of several things that may happen.
struct Future {
  double probability = 0;           ///< 0..1; those of all futures sum to 1.
  std::vector<ObstacleMove> moves;  ///< Obstacles that are not named stay.
};

/// One robot of a fleet, tied to its start.
struct FleetRobot {
  std::string name;               ///< Unique in the fleet.
  Point start;                    ///< Where it stands and is tied, metres.
  Point target;                   ///< Where it is to go, metres.
  std::optional<Polyline> cable;  ///< The target cable line, start to target.
  double speed = 0;               ///< Metres per second.
  double radius = 0;              ///< Of its body, metres; cables meet it as a point all the same.
  std::optional<double> tether;   ///< The length of its cable, metres; absent: as long as it takes.
};

/// Several tethered robots.
struct Fleet {
  std::vector<FleetRobot> robots;  ///< In the order of the scene.
};

/// All that one file says; each planner uses its part.
struct Scene {
  std::string path;                    ///< The file it came from; empty when built in memory.
  World world;                         ///< Where everything happens.
  std::optional<Tether> tether;        ///< Of the one tethered robot.
  RobotBody robot;                     ///< That robot.
  std::optional<Point> goal;           ///< Of the one robot, metres.
  std::optional<Cables> cables;        ///< Of a robot that cables move.
  std::vector<Point> tasks;            ///< Places that a workspace is to hold, metres.
  std::optional<double> max_boundary;  ///< Longest boundary of a workspace, metres.
  std::vector<Future> futures;         ///< Empty: nothing moves.
  std::optional<Fleet> fleet;          ///< Several robots instead of one.
};

}  // namespace tautline

#endif  // TAUTLINE_SCENE_SCENE_H_
