// A peer: the tethered plan on a grid of cells, whose states are (cell, reduced word).
#ifndef TAUTLINE_BENCH_PEERS_GRID_COVER_H_
#define TAUTLINE_BENCH_PEERS_GRID_COVER_H_

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "bench/peers/state_table.h"
#include "bench/peers/word_trie.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// An 8-connected grid over a free space [Igarashi2010, with words in place of the manifold's copies]. A cell is free
/// when no boundary passes through it and its centre is free; a diagonal step needs both cells beside it. Paths lie in
/// the free ground, and are up to 8 % longer than the exact ones, or more where ways are narrower than some cells.
class GridCover {
 public:
  /// The tethers of one length from one base: all states within it, by Dijkstra.
  struct Tethers {
    StateTable states;
    WordTrie words;
    bool gave_up = false;
  };

  struct Options {
    double max_length = std::numeric_limits<double>::infinity();  ///< Of the tether, metres, along the grid.
    std::size_t max_states = 20'000'000;                          ///< States after which a search gives up.
  };

  struct Motion {
    std::optional<double> length;  ///< Metres; nothing when there is no motion, or the search gave up.
    std::size_t states = 0;        ///< Reached.
    bool gave_up = false;
  };

  /// `cell`: the side of a cell, metres.
  GridCover(const TautSpace& space, double cell);

  /// The centre of the free cell that p lies in, or nothing.
  std::optional<Point> CentreAt(Point p) const;

  Tethers MakeTethers(Point base, const Options& options) const;

  /// A* with the octile distance from the robot, whose cable has the word `laid`, to the goal, through states that
  /// the tethers reach. Robot and goal are centres of free cells.
  struct Question {
    Point robot;
    Word laid;
    Point goal;
  };
  Motion Plan(Tethers& tethers, const Question& question, const Options& options) const;

 private:
  static constexpr std::size_t kSteps = 8;

  bool IsFree(int column, int row) const {
    return column >= 0 && column < columns_ && row >= 0 && row < rows_ && free_[Index(column, row)];
  }
  std::size_t Index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  std::int32_t CellAt(Point p) const;
  Point CentreOf(std::int32_t cell) const;
  void BlockBoundary(Point a, Point b);
  void AddSteps(const TautSpace& space);
  double Octile(std::int32_t a, std::int32_t b) const;

  template <class Offer>
  void ForEachStep(WordTrie& words, const PeerState& state, Offer offer) const;

  double cell_;
  Point low_;
  int columns_, rows_;
  std::vector<bool> free_;
  /// By cell and direction: 0 no step, 1 a step that crosses no ray, 2 + i one that writes letters_[i].
  std::vector<std::array<std::int32_t, kSteps>> steps_;
  std::vector<std::vector<std::int32_t>> letters_;
};

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PEERS_GRID_COVER_H_
