// A peer: Dijkstra over the h-augmented visibility graph, whose nodes are (vertex, reduced word).
#ifndef TAUTLINE_BENCH_PEERS_H_AUGMENTED_GRAPH_H_
#define TAUTLINE_BENCH_PEERS_H_AUGMENTED_GRAPH_H_

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "bench/peers/state_table.h"
#include "bench/peers/word_trie.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// How a search guesses the rest of the way. None of them changes the answer.
enum class Guess {
  kNothing,   ///< Dijkstra, as in [Wang2018, Sec. II].
  kStraight,  ///< A*: the distance as the crow flies.
  kExact,     ///< A*: the distance in the visibility graph without words, by one plain Dijkstra for each question.
};

/// A class and its shortest path.
struct PeerClass {
  double length = 0;  ///< Metres.
  Polyline points;
};

struct PeerOptions {
  Guess guess = Guess::kNothing;
  double max_length = std::numeric_limits<double>::infinity();  ///< Metres.
  std::size_t max_count = std::numeric_limits<std::size_t>::max();
  std::size_t max_states = 20'000'000;  ///< States after which a search gives up.
};

struct PeerClassList {
  std::vector<PeerClass> classes;  ///< Shortest first.
  std::size_t states = 0;          ///< Reached.
  bool gave_up = false;
};

struct PeerMotion {
  std::optional<double> length;  ///< Metres; nothing when there is no motion, or the search gave up.
  std::size_t states = 0;        ///< Reached.
  bool gave_up = false;
};

/// Which lines of sight are edges of the graph. The shortest path of each class is in all of them.
enum class SightLines {
  kAll,         ///< Between all boundary vertices: the visibility graph of [Wang2018, Sec. II-D].
  kTangent,     ///< Between reflex corners, tangent at one end at least: all that tethered motions need.
  kBitangents,  ///< Between reflex corners, tangent at both: the shortest-path roadmap. For FindClasses only.
};

/// The visibility graph with the letters that each edge writes; built once, and not counted in questions.
class HAugmentedGraph {
 public:
  struct Arc {
    std::int32_t to = 0;
    double length = 0;                  ///< Metres.
    std::vector<std::int32_t> letters;  ///< As WordTrie has them.
  };

  /// A point of a question, with the edges to all nodes that it sees.
  struct Terminal {
    Place place;
    std::vector<Arc> arcs;  ///< `to` is the node that it sees.
  };

  /// The tethers of one length from one base: all states within it.
  struct Cover {
    Terminal base;
    Terminal goal;
    StateTable states;
    WordTrie words;
    double length = 0;  ///< Metres.
    bool gave_up = false;
  };

  /// The tethered plan's question beside its cover.
  struct Start {
    Terminal robot;
    Word laid;
  };

  /// O(n^2) lines of sight with kAll for n boundary vertices. Requires that no boundaries touch.
  HAugmentedGraph(const TautSpace& space, SightLines lines);

  /// Connects a point to the graph; not counted in questions either. Requires a point in the free space.
  Terminal Connect(Point p) const;

  /// The classes between two points, shortest first: each time the goal is settled in a word that it was not settled
  /// in before, there is one more.
  PeerClassList FindClasses(const Terminal& from, const Terminal& to, const PeerOptions& options) const;

  /// All (vertex, word) within a tether's length from the base, by Dijkstra.
  Cover MakeCover(const Terminal& base, const Terminal& goal, const PeerOptions& options) const;

  /// The shortest motion from the robot, whose cable has the word start.laid, to the cover's goal, that visits only
  /// states of the cover. A* with the straight-line distance.
  PeerMotion Plan(Cover& cover, const Start& start, const PeerOptions& options) const;

 private:
  struct Search;

  void AddAll();
  void AddTangents();
  void AddBitangents();
  std::optional<Arc> Direct(const Terminal& from, const Terminal& to, std::int32_t node) const;
  std::vector<double> PlainDistances(const Terminal& to) const;
  void Expand(Search& search, std::int32_t id) const;

  const TautSpace* space_;
  SightLines lines_;
  std::vector<Point> nodes_;            ///< Corners, by CornerId, or all vertices.
  std::vector<std::vector<Arc>> arcs_;  ///< By node.
};

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PEERS_H_AUGMENTED_GRAPH_H_
