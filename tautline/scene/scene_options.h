// What the command line may change about how a scene and its map are read.
#ifndef TAUTLINE_SCENE_SCENE_OPTIONS_H_
#define TAUTLINE_SCENE_SCENE_OPTIONS_H_

namespace tautline {

/// How a scene and its map are read.
struct SceneOptions {
  bool unknown_free = false;  ///< Unknown cells of a ROS map are free rather than blocked.
  double simplify = 0;        ///< Metres (>= 0, finite) by which a boundary traced from cells may move, outwards
                              ///< only; 0: exact cell boundaries.
};

}  // namespace tautline

#endif  // TAUTLINE_SCENE_SCENE_OPTIONS_H_
