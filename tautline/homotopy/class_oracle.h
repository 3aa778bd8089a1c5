// Homotopy classes by Dijkstra over (vertex, word) on the full visibility graph: a slow oracle, for tests only.
#ifndef TAUTLINE_HOMOTOPY_CLASS_ORACLE_H_
#define TAUTLINE_HOMOTOPY_CLASS_ORACLE_H_

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tautline/homotopy/brute_sight.h"
#include "tautline/homotopy/word.h"

namespace tautline {

/// A class and the length of its shortest path.
struct OracleClass {
  double length = 0;  ///< Metres.
  Word word;
};

/// Reduced words as numbers: a word is its longest proper prefix and one more letter. 0 is the empty word.
class WordTable {
 public:
  /// A letter as a number: the obstacle k is k + 1, its inverse -(k + 1).
  int Append(int word, int letter);
  Word ToWord(int word) const;

 private:
  struct Entry {
    int parent;
    int letter;
  };
  std::vector<Entry> entries_{{-1, 0}};
  std::map<std::pair<int, int>, int> children_;
};

/// The scene of one oracle: a full visibility graph over all boundary points and some others, each edge with the
/// letters that it writes. The rays are its own: half-open on x, along the direction of travel within a column.
class ClassOracle {
 public:
  /// More states than this end a search without an answer.
  static constexpr std::size_t kMaxStates = 60'000;

  /// `representatives` by letter.
  ClassOracle(std::span<const Ring> rings, std::span<const Point> representatives, std::span<const Point> points);

  const BruteSight& sight() const { return sight_; }
  WordTable& words() { return words_; }

  /// The nodes that see a node and are not it.
  std::vector<std::size_t> NeighboursOf(std::size_t node) const;

  /// The word number of `word` with the letters of a polyline appended.
  int AppendPolyline(int word, std::span<const Point> polyline);

  /// The distance to the nearest of `targets`, from every node; infinite where there is no way. Plain Dijkstra.
  std::vector<double> DistancesTo(std::span<const std::size_t> targets) const;

  /// A node in a class, the distance to it.
  struct State {
    std::size_t node;
    int word;
    double length;
  };

  /// Visits (node, word) states from `start` with word `word` in order of their distance, until `visit` says false.
  /// States with length + remaining[node] > limit are left out, and so are those that `allowed` refuses; both may be
  /// empty functions. False when kMaxStates did not suffice.
  struct Search {
    std::vector<std::size_t> start;
    int word = 0;
    std::vector<double> remaining;
    double limit = 0;
    std::function<bool(const State&)> allowed;
  };
  bool Run(const Search& search, const std::function<bool(const State&)>& visit);

  /// All classes from one point to another whose shortest path is no longer than max_length, shortest first; nothing
  /// when there are too many.
  std::optional<std::vector<OracleClass>> Classes(Point from, Point to, double max_length);

  /// The same from one of the nodes to one of the others.
  std::optional<std::vector<OracleClass>> ClassesBetween(std::span<const std::size_t> from,
                                                         std::span<const std::size_t> to, double max_length);

  /// The length of the shortest path in the class `word` from one node to another; infinite when that is longer than
  /// at_most or not found within kMaxStates.
  double LengthOf(std::size_t from, std::size_t to, int word, double at_most);

 private:
  struct Arc {
    std::size_t to;
    double length;
    std::vector<int> letters;
  };

  std::vector<int> LettersOf(Point p, Point q) const;

  BruteSight sight_;
  std::vector<Point> representatives_;
  std::vector<std::vector<Arc>> arcs_;
  WordTable words_;
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_CLASS_ORACLE_H_
