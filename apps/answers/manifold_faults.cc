#include "apps/answers/manifold_faults.h"

#include "tautline/scene/number_text.h"

namespace tautline {

std::string BaseFault(const CellGround& ground, Point base) {
  const auto cell = ground.CellAt(base);
  if (!cell) return "the base " + ShortText(base) + " lies outside of the map";
  if (ground.IsFree(*cell)) return "";
  return "the base " + ShortText(base) + " lies in the cell about " + ShortText(ground.CentreOf(*cell)) +
         ", which an obstacle or a wall reaches into";
}

StopText ExplainStop(const GridManifold& manifold, const ManifoldOptions& options) {
  const std::string smaller = ", shorten the tether or give a larger --resolution";
  switch (manifold.stop()) {
    case ManifoldStop::kNone:
      return {};
    case ManifoldStop::kVertices:
      return {"the manifold has more than " + std::to_string(options.max_vertices) + " vertices",
              "raise --max-nodes" + smaller};
    case ManifoldStop::kBytes:
      return {"the manifold takes more than " + std::to_string(options.max_bytes) + " bytes",
              "raise --max-bytes" + smaller};
    case ManifoldStop::kAsked:
      return {"the search was stopped", "let it go on"};
    case ManifoldStop::kDistance:
      return {"the tether is longer than " + ShortNumber(kFarthestCells) +
                  " cells, the most that distances are told apart for",
              "give a larger --resolution"};
  }
  return {};
}

}  // namespace tautline
