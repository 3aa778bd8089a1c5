// The tables of a comparison, ours beside those of [Shimada2024].
#ifndef APPS_ANSWERS_COMPARE_TABLES_H_
#define APPS_ANSWERS_COMPARE_TABLES_H_

#include <span>
#include <string>
#include <vector>

#include "apps/answers/compare_search.h"
#include "apps/answers/json_values.h"

namespace tautline {

/// A mean and how far the values spread around it.
struct MeanSpread {
  double mean = 0;
  double spread = 0;  ///< The standard deviation over scenes and seeds; 0 for one value.
};

/// What the paths of one cell of a table come to. Means are over those whose robot reached the goal.
struct CompareCell {
  std::string group;
  std::string method;
  double cable_robot = 0;           ///< The reward for standing on the cable.
  bool reference = true;            ///< Trained with the reference path.
  int count = 0;                    ///< Paths.
  int success = 0;                  ///< Of these, so many were found, and tracked to the goal.
  MeanSpread length_m;              ///< Of the paths.
  MeanSpread cable_obstacle;        ///< Contacts a minute.
  MeanSpread cable_robot_contacts;  ///< Likewise.
};

/// One cell for each group, method and way of training, in the order in which they come first.
std::vector<CompareCell> CellsOf(std::span<const ComparedPath> paths);

/// The cells as JSON.
Json ToJson(const std::vector<CompareCell>& cells);

/// The tables as Markdown: all methods [Table 2], the reward for standing on the cable [Table 3], without the reference
/// [Sec. 6.3.4], each with the published numbers where the groups are named as the paper's cases: dots, two_bars,
/// dots_deployed, complex_deployed. `usual` is the reward for standing on the cable of the first table.
std::string CompareMarkdown(const std::vector<CompareCell>& cells, double usual);

}  // namespace tautline

#endif  // APPS_ANSWERS_COMPARE_TABLES_H_
