#include "tautline/draw/draw_deadlocks.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "tautline/draw/cell_shapes.h"
#include "tautline/draw/figure.h"
#include "tautline/draw/length_text.h"

namespace tautline {
namespace {

/// Contacts with a star and their tethers; more only make the picture dark.
constexpr std::size_t kMostStars = 40;
constexpr std::size_t kMostTethers = 6;

/// Shares of a cell's classes that are closed, up to these, and their colours.
struct Band {
  double share;
  const char* colour;
  const char* text;
};
constexpr std::array<Band, 3> kBands = {{{0.34, "#fbe3c8", "up to a third of the classes closed"},
                                         {0.999, "#f2b277", "more of them"},
                                         {1, "#cf6a2c", "all of them: no place to go"}}};

const LineStyle kReachedLine = {.colour = "#08306b", .width = 1};
const LineStyle kTetherLine = {.colour = "#8f6400", .width = 1.4};

/// By cell, the number of its vertices and how many of them are closed.
struct CellCounts {
  std::vector<std::uint32_t> all, closed;
};

CellCounts CountCellsOf(const GridManifold& manifold, const DeadlockAreas& areas) {
  CellCounts counts{manifold.Multiplicity(), std::vector<std::uint32_t>(manifold.ground().grid().cells.size())};
  for (std::uint32_t page = 0; page < manifold.pages(); ++page) {
    for (TileMask cells = manifold.vertices(page); cells != 0; cells &= cells - 1) {
      const ManifoldVertex v{page, __builtin_ctzll(cells)};
      const GridCell cell = manifold.CellOf(v);
      if (areas.IsClosed(v)) ++counts.closed[manifold.ground().grid().index(cell.column, cell.row)];
    }
  }
  return counts;
}

std::vector<bool> CellsIn(const CellCounts& counts, double above, double upto) {
  std::vector<bool> in(counts.all.size());
  for (std::size_t i = 0; i < in.size(); ++i) {
    if (counts.all[i] == 0) continue;
    const double share = static_cast<double>(counts.closed[i]) / counts.all[i];
    in[i] = share > above && share <= upto;
  }
  return in;
}

/// The places of contacts in the order in which they are drawn, each cell once.
struct Contacts {
  std::vector<std::size_t> locking;     ///< Those that close most first.
  std::vector<std::size_t> resolvable;  ///< The nearest of each run.
};

Contacts ContactsOf(const GridManifold& manifold, const DeadlockAreas& areas) {
  Contacts contacts;
  std::vector<const Deadlock*> order;
  for (const Deadlock& deadlock : areas.deadlocks()) order.push_back(&deadlock);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) { return a->closed > b->closed; });
  std::set<std::pair<int, int>> taken;
  std::vector<bool> locked(areas.contacts().size());
  const auto is_new = [&](std::size_t contact) {
    const GridCell cell = manifold.CellOf(areas.contacts()[contact].vertex);
    return taken.emplace(cell.column, cell.row).second;
  };
  for (const Deadlock* deadlock : order) {
    locked[areas.contacts()[deadlock->contact].run] = true;
    if (is_new(deadlock->contact)) contacts.locking.push_back(deadlock->contact);
  }
  for (std::size_t i = 0; i < areas.examined(); ++i) {
    const TetherContact& contact = areas.contacts()[i];
    if (contact.run != i || locked[i] || areas.IsClosed(contact.vertex)) continue;
    if (is_new(i)) contacts.resolvable.push_back(i);
  }
  return contacts;
}

Polyline TetherTo(const GridManifold& manifold, const TetherContact& contact) {
  Polyline line;
  for (const ManifoldVertex v : PathToBase(manifold, contact.vertex)) {
    line.push_back(manifold.ground().CentreOf(manifold.CellOf(v)));
  }
  return line;
}

FigureContent ContentOf(const Scene& scene, const GridManifold& manifold, const DeadlockAreas& areas,
                        const Contacts& contacts) {
  const double area =
      static_cast<double>(areas.closed_vertices()) * manifold.ground().cell_m() * manifold.ground().cell_m();
  FigureContent content;
  content.title = areas.deadlocks().empty()
                      ? "No contact locks the robot in"
                      : "Where the tether can lock the robot in: " + AreaText(area) + " over all classes";
  if (contacts.locking.size() > kMostStars) {
    content.notes.push_back("Stars are shown at the " + std::to_string(kMostStars) + " of " +
                            std::to_string(contacts.locking.size()) + " contacts that close most.");
  }
  if (contacts.resolvable.size() > kMostStars) {
    content.notes.push_back("Rings are shown at the " + std::to_string(kMostStars) + " nearest of " +
                            std::to_string(contacts.resolvable.size()) + " runs of contacts that are resolvable.");
  }
  if (areas.examined() < areas.contacts().size()) {
    content.notes.emplace_back("The search was stopped: farther contacts were not looked at.");
  }
  for (const Band& band : kBands) content.legend.push_back({GroundSwatch{.fill = band.colour}, band.text});
  content.legend.push_back({Marker::kStar, "contact that locks the robot in"});
  content.legend.push_back({kTetherLine, "the tether to it"});
  content.legend.push_back({Marker::kPoint, "contact that is resolvable"});
  content.shown.push_back(scene.tether->base);
  return content;
}

}  // namespace

std::string DrawDeadlocks(const Scene& scene, const GridManifold& manifold, const DeadlockAreas& areas) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  const CellCounts counts = CountCellsOf(manifold, areas);
  const Contacts contacts = ContactsOf(manifold, areas);
  Figure figure(scene, *space, ContentOf(scene, manifold, areas, contacts));
  double above = 0;
  for (const Band& band : kBands) {
    figure.Shape("closed", CellCurves(manifold.ground().grid(), CellsIn(counts, above, band.share), figure.view()),
                 {.fill = band.colour});
    above = band.share;
  }
  std::vector<bool> reached(counts.all.size());
  for (std::size_t i = 0; i < reached.size(); ++i) reached[i] = counts.all[i] > 0;
  figure.Shape("reached", CellCurves(manifold.ground().grid(), reached, figure.view()),
               {.stroke = kReachedLine.colour, .width = kReachedLine.width});
  for (std::size_t i = 0; i < std::min(kMostTethers, contacts.locking.size()); ++i) {
    figure.Line("tether", TetherTo(manifold, areas.contacts()[contacts.locking[i]]), kTetherLine);
  }
  const auto mark = [&](Marker marker, const std::vector<std::size_t>& numbers) {
    for (std::size_t i = std::min(kMostStars, numbers.size()); i-- > 0;) {
      figure.Mark(marker, manifold.ground().CentreOf(manifold.CellOf(areas.contacts()[numbers[i]].vertex)));
    }
  };
  mark(Marker::kPoint, contacts.resolvable);
  mark(Marker::kStar, contacts.locking);
  figure.Mark(Marker::kBase, scene.tether->base, "base");
  return figure.Finish();
}

}  // namespace tautline
