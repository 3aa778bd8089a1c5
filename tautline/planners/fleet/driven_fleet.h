// Large random fleets for tests and benchmarks: what comes out when robots drive as they please.
#ifndef TAUTLINE_PLANNERS_FLEET_DRIVEN_FLEET_H_
#define TAUTLINE_PLANNERS_FLEET_DRIVEN_FLEET_H_

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/base/rng.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/taut_strings.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What FleetInRows makes.
struct FleetInRowsOptions {
  std::size_t robots = 100;  ///< In rows of about as many robots as there are rows.
  std::size_t row = 0;       ///< Robots in a row; 0: about the root of `robots`.
  double reach = 6;          ///< How far a target is from its start along the row at most, in steps of the row.
  double height = 4;         ///< The height of a strip, in the same steps.
  double detours = 0.02;     ///< The share of robots that were led over another place, so that deadlocks occur.
};

namespace driven_fleet {

/// A robot while the layout is made: it drives along a broken line, later or faster than others.
struct Driver {
  Polyline way;
  double delay = 0;
  double speed = 1;

  double TimeAt(double along) const { return delay + along / speed; }
};

/// A robot is at a place of its way at a time.
struct Stop {
  double time = 0;
  std::size_t robot = 0;
  std::size_t order = 0;  ///< Among the stops of the robot.
  bool turns = false;     ///< Whether its way bends there.
  Point at;
};

/// How far along its way a driver is when it crosses another one's, and at its bends.
struct Marks {
  std::vector<double> crossings, bends;
};

inline Point PointAt(const Polyline& way, double along) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length = Distance(way[i - 1], way[i]);
    if (along <= length || i + 1 == way.size()) return Lerp(way[i - 1], way[i], std::min(1.0, along / length));
    along -= length;
  }
  return way.back();
}

inline Marks FindMarks(const std::vector<Driver>& drivers, std::size_t robot) {
  Marks marks;
  const Polyline& way = drivers[robot].way;
  double along = 0;
  for (std::size_t i = 1; i < way.size(); along += Distance(way[i - 1], way[i]), ++i) {
    if (i > 1) marks.bends.push_back(along);
    for (std::size_t other = 0; other < drivers.size(); ++other) {
      const Polyline& line = drivers[other].way;
      for (std::size_t j = 1; other != robot && j < line.size(); ++j) {
        if (!CrossProperly(way[i - 1], way[i], line[j - 1], line[j])) continue;
        const Point d = way[i] - way[i - 1], e = line[j] - line[j - 1];
        marks.crossings.push_back(along + Norm(d) * Cross(line[j - 1] - way[i - 1], e) / Cross(d, e));
      }
    }
  }
  std::sort(marks.crossings.begin(), marks.crossings.end());
  return marks;
}

/// The pieces between which a robot rests, each with the time at which it passes what is inside of it.
inline void AddStops(const std::vector<Driver>& drivers, std::size_t robot, std::vector<Stop>& stops) {
  const Driver& driver = drivers[robot];
  const Marks marks = FindMarks(drivers, robot);
  double length = 0;
  for (std::size_t i = 1; i < driver.way.size(); ++i) length += Distance(driver.way[i - 1], driver.way[i]);
  std::vector<double> ends = marks.bends;
  for (std::size_t i = 1; i < marks.crossings.size(); ++i) {
    ends.push_back((marks.crossings[i - 1] + marks.crossings[i]) / 2);
  }
  ends.push_back(length);
  std::sort(ends.begin(), ends.end());
  std::size_t order = 0;
  for (const double end : ends) {
    const auto inside = std::lower_bound(marks.crossings.begin(), marks.crossings.end(), end);
    const double along = inside == marks.crossings.begin() ? 0 : *(inside - 1);
    const bool turns = std::binary_search(marks.bends.begin(), marks.bends.end(), end);
    const Point at = end == length ? driver.way.back() : PointAt(driver.way, end);
    stops.push_back({driver.TimeAt(along), robot, order++, turns, at});
  }
}

/// Lets all drive; the cable lines that come out, or nothing where somebody drove exactly over somebody else.
inline std::optional<std::vector<Polyline>> Drive(const std::vector<Driver>& drivers) {
  const std::size_t n = drivers.size();
  std::vector<Point> pins;
  for (int copy = 0; copy < 2; ++copy) {
    for (const Driver& driver : drivers) pins.push_back(driver.way.front());
  }
  std::vector<Point> places;
  for (const Driver& driver : drivers) places.insert(places.end(), driver.way.begin(), driver.way.end());
  TautStrings strings(pins, places);
  for (std::size_t i = 0; i < n; ++i) strings.Tie(PinId(i), PinId(n + i));
  std::vector<Stop> stops;
  for (std::size_t i = 0; i < n; ++i) AddStops(drivers, i, stops);
  std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) {
    return a.time != b.time ? a.time < b.time : a.robot != b.robot ? a.robot < b.robot : a.order < b.order;
  });
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const Stop& stop = stops[i];
    if (!stop.turns && i + 1 < stops.size() && stops[i + 1].robot == stop.robot) continue;  // It may as well drive on.
    if (!strings.Move(PinId(n + stop.robot), stop.at)) return std::nullopt;
  }
  std::vector<Polyline> cables;
  for (std::size_t i = 0; i < n; ++i) {
    Polyline cable;
    for (const StringBend& bend : strings.bends(StringId(i))) cable.push_back(strings.point(bend.pin));
    cables.push_back(std::move(cable));
  }
  return cables;
}

/// Whether a cable line comes to no point twice and bends at no start, all of which are on the border.
inline bool IsPlain(const Polyline& cable, double border) {
  Polyline points = cable;
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) == points.end() &&
         std::all_of(cable.begin() + 1, cable.end(), [&](Point p) { return p.y > border; });
}

inline Driver RandomDriver(Rng& rng, const FleetInRowsOptions& options, Point start) {
  const auto place = [&] {
    return start + Point{rng.Uniform(-options.reach, options.reach), options.height * rng.Uniform(0.1, 0.9)};
  };
  Driver driver{{start}, rng.Uniform(0, options.height), rng.Uniform(0.5, 2)};
  if (rng.Uniform() < options.detours) driver.way.push_back(place());
  driver.way.push_back(place());
  return driver;
}

inline void AddRobots(Rng& rng, const std::vector<Driver>& drivers, const std::vector<Polyline>& cables, Fleet& fleet) {
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    FleetRobot robot;
    robot.name = "r" + std::to_string(fleet.robots.size() + 1);
    robot.start = drivers[i].way.front();
    robot.target = drivers[i].way.back();
    robot.cable = cables[i];
    robot.speed = rng.Uniform(0.25, 1);
    fleet.robots.push_back(std::move(robot));
  }
}

/// One row with the strip above it. Robots whose cables come out with loops are sent elsewhere.
inline void AddRow(Rng& rng, const FleetInRowsOptions& options, std::size_t count, double y, Fleet& fleet) {
  std::vector<Driver> drivers;
  for (std::size_t i = 0; i < count; ++i) {
    drivers.push_back(RandomDriver(rng, options, {static_cast<double>(i) + rng.Uniform(0.1, 0.9), y}));
  }
  std::optional<std::vector<Polyline>> cables;
  for (bool plain = false; !plain;) {
    cables = Drive(drivers);
    plain = cables.has_value();
    for (std::size_t i = 0; i < count; ++i) {
      if (cables && IsPlain((*cables)[i], y)) continue;
      drivers[i] = RandomDriver(rng, options, drivers[i].way.front());
      plain = false;
    }
  }
  AddRobots(rng, drivers, *cables, fleet);
}

}  // namespace driven_fleet

/// Robots on parallel rows, a step of 1 m apart, each with a target in the strip above its row and the cable line that
/// it has after all have driven there, straight or over another place, at random times. So the layout is free of
/// crossings, and no start is inside of a cable polygon, since each stands on the border of a convex strip.
inline Scene FleetInRows(Rng& rng, const FleetInRowsOptions& options = {}) {
  Scene scene;
  scene.fleet.emplace();
  const std::size_t row =
      options.row > 0 ? options.row : static_cast<std::size_t>(std::ceil(std::sqrt(double(options.robots))));
  for (std::size_t made = 0, rows = 0; made < options.robots; ++rows) {
    const std::size_t count = std::min(row, options.robots - made);
    driven_fleet::AddRow(rng, options, count, options.height * static_cast<double>(rows), *scene.fleet);
    made += count;
  }
  return scene;
}

/// Two flocks side by side that go through each other: each robot of one crosses the path of each robot of the other,
/// and those of the second flock come later and push the cables of the first. As many crossings as there can be without
/// cables that come back to themselves.
inline Scene TwoFlocks(Rng& rng, std::size_t robots) {
  const auto half = static_cast<double>(robots) / 2;
  std::vector<driven_fleet::Driver> drivers;
  for (std::size_t i = 0; i < robots; ++i) {
    const bool first = 2 * i < robots;
    const Point start{static_cast<double>(i) + (first ? 0 : half) + rng.Uniform(0.1, 0.9), 0};
    const double length = rng.Uniform(4, 5) * half;
    drivers.push_back(
        {{start, start + length * Point{first ? 0.8 : -0.8, 0.6}}, first ? 0 : 10 * half * static_cast<double>(i), 1});
  }
  const auto cables = driven_fleet::Drive(drivers);
  TAUTLINE_CHECK(cables.has_value());
  Scene scene;
  scene.fleet.emplace();
  driven_fleet::AddRobots(rng, drivers, *cables, *scene.fleet);
  return scene;
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_DRIVEN_FLEET_H_
