#include "apps/answers/compare_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

namespace tautline {
namespace {

/// A row of the paper's Table 2, or 3.
struct Published {
  const char* group;
  const char* method;
  double cable_robot;
  double length_m, cable_obstacle, cable_robot_contacts;
  const char* success;
};

/// [Shimada2024, Tables 2 and 3]; "learned" is its TCFPP. Table 3 prints magnitudes, and its note on deadlocks belongs
/// to the first row.
constexpr std::array kPublished = {Published{"dots", "dijkstra", -0.5, 7.93, 8.37, 0, ""},
                                   Published{"dots", "voronoi", -0.5, 10.64, 1.13, 38.5, ""},
                                   Published{"dots", "learned", -0.5, 8.92, 1.20, 0, ""},
                                   Published{"two_bars", "dijkstra", -0.5, 12.0, 15.1, 0, ""},
                                   Published{"two_bars", "voronoi", -0.5, 16.8, 0, 0, ""},
                                   Published{"two_bars", "learned", -0.5, 14.3, 10.6, 0, ""},
                                   Published{"dots_deployed", "dijkstra", -0.5, 13.2, 21.1, 28.4, ""},
                                   Published{"dots_deployed", "voronoi", -0.5, 18.7, 0, 40.8, ""},
                                   Published{"dots_deployed", "learned", -0.5, 17.3, 0.55, 17.6, "5/5"},
                                   Published{"complex_deployed", "dijkstra", -0.5, 11.1, 12.4, 40.6, ""},
                                   Published{"complex_deployed", "voronoi", -0.5, 14.8, 1.52, 62.7, ""},
                                   Published{"complex_deployed", "learned", -0.5, 13.2, 1.60, 37.3, ""},
                                   Published{"dots_deployed", "learned", -1, 15.6, 0, 6.22, "3/5"},
                                   Published{"dots_deployed", "learned", 0, 18.0, 1.04, 44.10, "5/5"}};

MeanSpread MeanOf(const std::vector<double>& values) {
  if (values.empty()) return {};
  MeanSpread result;
  for (const double value : values) result.mean += value / static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  if (values.size() > 1) result.spread = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return result;
}

bool SameCell(const ComparedPath& a, const ComparedPath& b) {
  return a.group == b.group && a.method == b.method && a.cable_robot == b.cable_robot && a.reference == b.reference;
}

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, std::abs(value) < 10 ? "%.2f" : "%.1f", value);
  return text;
}

std::string Text(const MeanSpread& value) { return Number(value.mean) + " ± " + Number(value.spread); }

std::string Row(const CompareCell& cell, const std::string& first, const std::string& second) {
  const Published* published = nullptr;
  for (const Published& one : kPublished) {
    if (cell.reference && one.group == cell.group && one.method == cell.method && one.cable_robot == cell.cable_robot) {
      published = &one;
    }
  }
  std::string row =
      "| " + first + " | " + second + " | " + std::to_string(cell.success) + "/" + std::to_string(cell.count) + " | ";
  row += cell.success == 0 ? "| | | "
                           : Text(cell.length_m) + " | " + Text(cell.cable_obstacle) + " | " +
                                 Text(cell.cable_robot_contacts) + " | ";
  if (published == nullptr) return row + "| | |\n";
  return row + Number(published->length_m) + " | " + Number(published->cable_obstacle) + " | " +
         Number(published->cable_robot_contacts) + " |\n";
}

std::string Head(const std::string& title, const std::string& first, const std::string& second) {
  return "### " + title + "\n\n| " + first + " | " + second +
         " | success | length, m | cable-obstacle /min | cable-robot /min | paper: length | cable-obstacle | "
         "cable-robot "
         "|\n|---|---|---|---|---|---|---|---|---|\n";
}

}  // namespace

std::vector<CompareCell> CellsOf(std::span<const ComparedPath> paths) {
  std::vector<CompareCell> cells;
  for (auto first = paths.begin(); first != paths.end(); ++first) {
    if (std::any_of(paths.begin(), first, [&](const ComparedPath& path) { return SameCell(path, *first); })) continue;
    CompareCell cell{.group = first->group,
                     .method = first->method,
                     .cable_robot = first->cable_robot,
                     .reference = first->reference,
                     .length_m = {},
                     .cable_obstacle = {},
                     .cable_robot_contacts = {}};
    std::vector<double> lengths, obstacle, robot;
    for (const ComparedPath& path : paths) {
      if (!SameCell(path, *first)) continue;
      ++cell.count;
      if (!path.success) continue;
      ++cell.success;
      lengths.push_back(path.length_m);
      obstacle.push_back(path.PerMinute(path.cable_obstacle));
      robot.push_back(path.PerMinute(path.cable_robot_steps));
    }
    cell.length_m = MeanOf(lengths);
    cell.cable_obstacle = MeanOf(obstacle);
    cell.cable_robot_contacts = MeanOf(robot);
    cells.push_back(cell);
  }
  return cells;
}

Json ToJson(const std::vector<CompareCell>& cells) {
  Json json = Json::array();
  for (const CompareCell& cell : cells) {
    json.push_back({{"group", cell.group},
                    {"method", cell.method},
                    {"reward_cable_robot", cell.cable_robot},
                    {"reference", cell.reference},
                    {"count", cell.count},
                    {"success", cell.success},
                    {"length", cell.length_m.mean},
                    {"length_spread", cell.length_m.spread},
                    {"cable_obstacle_per_minute", cell.cable_obstacle.mean},
                    {"cable_obstacle_spread", cell.cable_obstacle.spread},
                    {"cable_robot_per_minute", cell.cable_robot_contacts.mean},
                    {"cable_robot_spread", cell.cable_robot_contacts.spread}});
  }
  return json;
}

std::string CompareMarkdown(const std::vector<CompareCell>& cells, double usual) {
  std::string methods = Head("All methods, tracked by pure pursuit", "case", "method");
  std::string penalties, ablation;
  for (const CompareCell& cell : cells) {
    if (cell.reference && cell.cable_robot == usual) methods += Row(cell, cell.group, cell.method);
  }
  const auto add_group = [&](std::string& table, const std::string& group, bool with_penalties) {
    for (const CompareCell& cell : cells) {
      if (cell.group != group || cell.method != "learned") continue;
      if (with_penalties && cell.reference) table += Row(cell, group, Number(cell.cable_robot));
      if (!with_penalties && cell.cable_robot == usual) table += Row(cell, group, cell.reference ? "with" : "without");
    }
  };
  std::vector<std::string> penalised, ablated;
  const auto note = [](std::vector<std::string>& groups, const std::string& group) {
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  };
  for (const CompareCell& cell : cells) {
    if (cell.method == "learned" && cell.cable_robot != usual) note(penalised, cell.group);
    if (!cell.reference) note(ablated, cell.group);
  }
  for (const std::string& group : penalised) add_group(penalties, group, true);
  for (const std::string& group : ablated) add_group(ablation, group, false);
  if (!penalties.empty()) {
    penalties = "\n" + Head("The reward for standing on the cable", "case", "reward") + penalties;
  }
  if (!ablation.empty()) ablation = "\n" + Head("Without the reference path", "case", "reference") + ablation;
  return methods + penalties + ablation;
}

}  // namespace tautline
