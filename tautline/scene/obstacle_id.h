// The number of an obstacle.
#ifndef TAUTLINE_SCENE_OBSTACLE_ID_H_
#define TAUTLINE_SCENE_OBSTACLE_ID_H_

#include "tautline/base/index.h"

namespace tautline {

/// An island of a free space by position, that is, a letter of its words.
using ObstacleId = Index<struct ObstacleTag>;

}  // namespace tautline

#endif  // TAUTLINE_SCENE_OBSTACLE_ID_H_
