#include "apps/answers/deadlock_json.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace tautline {
namespace {

constexpr char kWalls[] = "walls";

double DistanceTo(const Obstacle& obstacle, Point p) {
  double least = std::numeric_limits<double>::infinity();
  if (obstacle.circle) least = std::max(0.0, Distance(obstacle.circle->centre, p) - obstacle.circle->radius);
  if (!obstacle.polygon) return least;
  const Ring& ring = obstacle.polygon->outer;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least = std::min(least, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  }
  return least;
}

/// An obstacle that is joined to walls is no island. It is the cause where it comes nearest to the contact and may
/// reach into a cell beside that.
std::string CauseOf(const World& world, const GridManifold& manifold, const TetherContact& contact) {
  const CellGround& ground = manifold.ground();
  if (contact.obstacle) return ground.names()[contact.obstacle->value()];
  const Point at = ground.CentreOf(manifold.CellOf(contact.vertex));
  double least = 1.5 * std::numbers::sqrt2 * ground.cell_m() + world.clearance;
  std::string cause = kWalls;
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    const Obstacle& obstacle = world.obstacles[i];
    const double distance = DistanceTo(obstacle, at);
    if (obstacle.from_map || distance >= least) continue;
    least = distance;
    cause = obstacle.name.empty() ? "o" + std::to_string(i + 1) : obstacle.name;
  }
  return cause;
}

Json ContactJson(const World& world, const GridManifold& manifold, const TetherContact& contact) {
  const Point at = manifold.ground().CentreOf(manifold.CellOf(contact.vertex));
  Json json;
  json["contact"] = Json::array({at.x, at.y});
  const Word word = manifold.WordOf(contact.vertex);
  json["word"] = ToStrings(word, manifold.ground().names());
  json["distance"] = manifold.DistanceM(contact.vertex);
  json["obstacle"] = CauseOf(world, manifold, contact);
  return json;
}

/// The nearest contact of every run that has no deadlock and was looked at.
std::vector<std::size_t> ResolvableRuns(const DeadlockAreas& areas) {
  std::vector<bool> locked(areas.contacts().size());
  for (const Deadlock& deadlock : areas.deadlocks()) locked[areas.contacts()[deadlock.contact].run] = true;
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < areas.examined(); ++i) {
    const TetherContact& contact = areas.contacts()[i];
    if (contact.run == i && !locked[i] && !areas.IsClosed(contact.vertex)) runs.push_back(i);
  }
  return runs;
}

}  // namespace

std::vector<DeadlockCause> CausesOf(const World& world, const GridManifold& manifold, const DeadlockAreas& areas) {
  std::map<std::string, DeadlockCause> by_name;
  for (const Deadlock& deadlock : areas.deadlocks()) {
    const std::string name = CauseOf(world, manifold, areas.contacts()[deadlock.contact]);
    DeadlockCause& cause = by_name[name];
    cause.obstacle = name;
    ++cause.deadlocks;
    cause.closed += deadlock.closed;
  }
  std::vector<DeadlockCause> causes;
  causes.reserve(by_name.size());
  for (auto& [name, cause] : by_name) causes.push_back(std::move(cause));
  std::stable_sort(causes.begin(), causes.end(),
                   [](const DeadlockCause& a, const DeadlockCause& b) { return a.closed > b.closed; });
  return causes;
}

void AddDeadlocks(const World& world, const GridManifold& manifold, const DeadlockAreas& areas, Json& json) {
  const double cell_area = manifold.ground().cell_m() * manifold.ground().cell_m();
  json["contacts"] = areas.contacts().size();
  json["closed_vertices"] = areas.closed_vertices();
  json["deadlock_area"] = static_cast<double>(areas.closed_vertices()) * cell_area;
  json["lost_area"] = static_cast<double>(areas.LostCells()) * cell_area;
  json["deadlock_obstacles"] = Json::array();
  for (const DeadlockCause& cause : CausesOf(world, manifold, areas)) {
    Json& item = json["deadlock_obstacles"].emplace_back();
    item["obstacle"] = cause.obstacle;
    item["deadlocks"] = cause.deadlocks;
    item["area"] = static_cast<double>(cause.closed) * cell_area;
  }
  json["deadlocks"] = Json::array();
  for (const Deadlock& deadlock : areas.deadlocks()) {
    Json item = ContactJson(world, manifold, areas.contacts()[deadlock.contact]);
    item["resolvable"] = false;
    item["farthest"] = CellsOf(deadlock.farthest) * manifold.ground().cell_m();
    item["area"] = static_cast<double>(deadlock.beyond) * cell_area;
    item["newly_closed"] = static_cast<double>(deadlock.closed) * cell_area;
    json["deadlocks"].push_back(std::move(item));
  }
  for (const std::size_t i : ResolvableRuns(areas)) {
    Json item = ContactJson(world, manifold, areas.contacts()[i]);
    item["resolvable"] = true;
    json["deadlocks"].push_back(std::move(item));
  }
}

}  // namespace tautline
