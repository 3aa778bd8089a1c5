// Workspaces side by side, one small map for each: candidates, or what the future may bring.
#ifndef TAUTLINE_DRAW_WORKSPACE_PANELS_H_
#define TAUTLINE_DRAW_WORKSPACE_PANELS_H_

#include <string>
#include <vector>

#include "tautline/homotopy/taut_path.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// A translucent layer with an outline.
struct PanelLayer {
  std::string colour;       ///< A CSS colour.
  std::vector<Ring> rings;  ///< Rings inside of rings are holes; metres.
};

/// One small map.
struct WorkspacePanel {
  const World* world;                   ///< As it is in this panel; must outlive the drawing.
  const FreeSpace* space;               ///< Of that world.
  std::string title;                    ///< In bold above the map.
  std::vector<std::string> notes;       ///< Lines below the title, cut to the panel's width.
  std::vector<Point> anchors;           ///< Marked as winches.
  Ring boundary;                        ///< Of the workspace; empty where there is none.
  std::vector<TautPath> sides = {};     ///< Without a boundary: its sides as far as they are known.
  std::vector<Point> tasks = {};        ///< Marked.
  std::vector<Polyline> moves = {};     ///< Ways that obstacles came, drawn with arrows.
  std::vector<PanelLayer> layers = {};  ///< Under all else but the ground.
};

/// What stands on the page around the panels.
struct PanelsContent {
  std::string title;                    ///< The answer in words.
  std::vector<std::string> notes = {};  ///< Sentences below it.
};

/// The panels in rows, all maps of one scale, as SVG. Requires a panel. Deterministic.
std::string DrawWorkspacePanels(const PanelsContent& content, const std::vector<WorkspacePanel>& panels);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_WORKSPACE_PANELS_H_
