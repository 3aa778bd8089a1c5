#include "tautline/scene/obstacle_naming.h"

#include <algorithm>

namespace tautline {

std::string ObstacleNaming::ByPosition(std::size_t position) {
  next_ = std::max(next_, position);
  while (!Take("o" + std::to_string(next_))) ++next_;
  return "o" + std::to_string(next_);
}

std::string ObstacleNaming::Variant(const std::string& name) {
  if (Take(name)) return name;
  std::size_t& count = counts_[name];
  do {
    count = std::max<std::size_t>(count + 1, 2);
  } while (!Take(name + "_" + std::to_string(count)));
  return name + "_" + std::to_string(count);
}

std::vector<std::string> ObstacleNames(const World& world) {
  std::vector<std::string> names;
  bool complete = true;
  for (const Obstacle& obstacle : world.obstacles) {
    names.push_back(obstacle.name);
    complete = complete && !obstacle.name.empty();
  }
  if (complete) return names;
  ObstacleNaming naming;
  for (const std::string& name : names) naming.Take(name);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) names[i] = naming.ByPosition(i + 1);
  }
  return names;
}

}  // namespace tautline
