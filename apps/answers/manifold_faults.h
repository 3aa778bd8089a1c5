// Why a manifold cannot be built, or not to its end, in words.
#ifndef APPS_ANSWERS_MANIFOLD_FAULTS_H_
#define APPS_ANSWERS_MANIFOLD_FAULTS_H_

#include <string>

#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// Why the base is no vertex; empty when it is one.
std::string BaseFault(const CellGround& ground, Point base);

/// Why a manifold is not complete.
struct StopText {
  std::string what;  ///< A sentence without its full stop; empty where the manifold is complete.
  std::string mend;  ///< What to do about it, as it goes on after a colon.
};

/// The same for a manifold and what it was built with.
StopText ExplainStop(const GridManifold& manifold, const ManifoldOptions& options);

}  // namespace tautline

#endif  // APPS_ANSWERS_MANIFOLD_FAULTS_H_
