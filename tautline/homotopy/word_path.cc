#include "tautline/homotopy/word_path.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

namespace tautline {
namespace {

/// A node of the cover's dual tree: a triangle, reached through a side.
struct Node {
  TriangleId triangle;
  Point entry;                ///< The middle of that side; the start in the first triangle.
  Word missing;               ///< What the way from here to the goal must still write.
  std::int64_t parent = -1;
  double depth = 0;           ///< Sides passed.
};

class WordPathSearch {
 public:
  WordPathSearch(const TautSpace& space, Place from, Place to, const Word& word)
      : space_(space),
        from_(from),
        to_(to),
        // A letter costs about as much as crossing the whole mesh once, so that words are completed before detours.
        letter_cost_(2 * std::sqrt(static_cast<double>(space.mesh().triangulation().triangles().size()))) {
    Push({from.triangle, from.point, word, -1, 0});
  }

  WordPath Run(std::int64_t budget) {
    while (!queue_.empty()) {
      if (--budget < 0) return {std::nullopt, true};
      const std::int64_t position = queue_.top().second;
      queue_.pop();
      const Node& node = nodes_[static_cast<std::size_t>(position)];
      if (node.triangle == to_.triangle && WordBetween(node.entry, to_.point) == node.missing) {
        return {PathTo(position), false};
      }
      Expand(position);
    }
    return {};
  }

 private:
  using Entry = std::pair<double, std::int64_t>;

  Word WordBetween(Point a, Point b) const {
    const Point segment[] = {a, b};
    return space_.rays().WordOf(segment);
  }

  void Push(Node node) {
    queue_.emplace(node.depth + letter_cost_ * static_cast<double>(node.missing.size()),
                   static_cast<std::int64_t>(nodes_.size()));
    nodes_.push_back(std::move(node));
  }

  void Expand(std::int64_t position) {
    const Node node = nodes_[static_cast<std::size_t>(position)];
    const TriangleId before = node.parent < 0 ? TriangleId() : nodes_[static_cast<std::size_t>(node.parent)].triangle;
    const Triangle& here = space_.mesh().triangle(node.triangle);
    for (int i = 0; i < 3; ++i) {
      const TriangleId across = here.neighbour(i);
      if (here.is_constrained(i) || across == before) continue;
      const Point middle = Lerp(space_.mesh().triangulation().corner(node.triangle, Next(i)),
                                space_.mesh().triangulation().corner(node.triangle, Previous(i)), 0.5);
      Push({across, middle, WordBetween(node.entry, middle).Inverse() * node.missing, position, node.depth + 1});
    }
  }

  TautPath PathTo(std::int64_t position) const {
    std::vector<TriangleId> triangles;
    for (; position >= 0; position = nodes_[static_cast<std::size_t>(position)].parent) {
      triangles.push_back(nodes_[static_cast<std::size_t>(position)].triangle);
    }
    Walk walk(from_);
    for (auto it = triangles.rbegin(); it != triangles.rend(); ++it) walk.sleeve.Step(*it);
    walk.at = to_.point;
    return space_.Pull(walk);
  }

  const TautSpace& space_;
  Place from_, to_;
  double letter_cost_;
  std::vector<Node> nodes_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

WordPath FindWordPath(const TautSpace& space, Place from, Place to, const Word& word, const WordPathOptions& options) {
  return WordPathSearch(space, from, to, word).Run(options.budget);
}

}  // namespace tautline
