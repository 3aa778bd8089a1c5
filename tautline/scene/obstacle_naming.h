// How obstacles come to their names: one rule for files and for worlds built in C++.
#ifndef TAUTLINE_SCENE_OBSTACLE_NAMING_H_
#define TAUTLINE_SCENE_OBSTACLE_NAMING_H_

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tautline/scene/scene.h"

namespace tautline {

/// Hands out names: those that are given, each once, and o1, o2, ... for the rest.
class ObstacleNaming {
 public:
  /// Whether the name was still to be had; now it is not.
  bool Take(const std::string& name) { return taken_.insert(name).second; }

  /// The name for the obstacle at a position, from 1: the first one from o<position> on that is not taken.
  std::string ByPosition(std::size_t position);

  /// The name itself, or with _2, _3, ... behind it when it is taken.
  std::string Variant(const std::string& name);

 private:
  std::set<std::string> taken_;
  std::map<std::string, std::size_t> counts_;
  std::size_t next_ = 1;
};

/// The names of a world's obstacles, in order: their own, and for those that have none the name by position. O(n log
/// n).
std::vector<std::string> ObstacleNames(const World& world);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_OBSTACLE_NAMING_H_
