#include "tautline/planners/grid_manifold/tile_relaxation.h"

#include <cstring>

// One binary serves all processors: where the compiler can, it makes a second version for wide vectors and chooses when
// the program starts. Both compute with integers, so they agree to the bit.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__SANITIZE_ADDRESS__)
#define TAUTLINE_WIDE_VECTORS __attribute__((target_clones("avx2", "default"), flatten))
#else
#define TAUTLINE_WIDE_VECTORS
#endif

namespace tautline {
namespace {

/// Eight lanes, lane 0 in the west. An extension of GCC and clang.
using Row = LatticeDistance __attribute__((vector_size(32)));

constexpr Row kFar{kUnreached, kUnreached, kUnreached, kUnreached, kUnreached, kUnreached, kUnreached, kUnreached};
constexpr Row kLaneBits{1, 2, 4, 8, 16, 32, 64, 128};

inline void LowerTo(Row& row, const Row& other) { row = other < row ? other : row; }

/// The same in the lanes of a mask.
inline void LowerTo(Row& row, const Row& other, TileMask mask, int at) {
  const auto bits = static_cast<LatticeDistance>((mask >> (8 * at)) & 0xff);
  const Row lanes = (Row{bits, bits, bits, bits, bits, bits, bits, bits} & kLaneBits) == kLaneBits;
  row = ((other < row) & lanes) ? other : row;
}

/// Each lane gets the one so many to the west of it.
template <int kLanes>
inline void FromWest(const Row& row, Row& result) {
  if constexpr (kLanes == 1) result = __builtin_shufflevector(row, kFar, 8, 0, 1, 2, 3, 4, 5, 6);
  if constexpr (kLanes == 2) result = __builtin_shufflevector(row, kFar, 8, 8, 0, 1, 2, 3, 4, 5);
  if constexpr (kLanes == 4) result = __builtin_shufflevector(row, kFar, 8, 8, 8, 8, 0, 1, 2, 3);
}

/// Each lane gets the one so many to the east of it.
template <int kLanes>
inline void FromEast(const Row& row, Row& result) {
  if constexpr (kLanes == 1) result = __builtin_shufflevector(row, kFar, 1, 2, 3, 4, 5, 6, 7, 8);
  if constexpr (kLanes == 2) result = __builtin_shufflevector(row, kFar, 2, 3, 4, 5, 6, 7, 8, 8);
  if constexpr (kLanes == 4) result = __builtin_shufflevector(row, kFar, 4, 5, 6, 7, 8, 8, 8, 8);
}

template <int kLanes>
inline void SpreadOpen(Row& row) {
  Row west, east;
  FromWest<kLanes>(row, west);
  FromEast<kLanes>(row, east);
  west += kLanes * kStraightStep;
  east += kLanes * kStraightStep;
  LowerTo(row, west);
  LowerTo(row, east);
}

/// Lowers `row` by steps from the row beside it.
inline void StepOpen(Row& row, const Row& beside, bool diagonal) {
  LowerTo(row, beside + kStraightStep);
  if (!diagonal) return;
  Row west, east;
  FromWest<1>(beside, west);
  FromEast<1>(beside, east);
  LowerTo(row, west + kDiagonalStep);
  LowerTo(row, east + kDiagonalStep);
}

/// In an open tile a shortest way is straight east or west first and then all north or all south: one pass does.
inline void SweepOpen(Row* rows, bool diagonal) {
  for (int i = 0; i < kTileSide; ++i) {
    SpreadOpen<1>(rows[i]);
    SpreadOpen<2>(rows[i]);
    SpreadOpen<4>(rows[i]);
  }
  for (int i = 1; i < kTileSide; ++i) StepOpen(rows[i], rows[i - 1], diagonal);
  for (int i = kTileSide - 1; i-- > 0;) StepOpen(rows[i], rows[i + 1], diagonal);
}

/// Which cells may take over the distance of the cell 1, 2 or 4 to the west or east.
struct Runs {
  TileMask west1, west2, west4, east1, east2, east4;
};

inline Runs RunsOf(const TileMoves& moves) {
  Runs runs{};
  runs.west1 = moves[4];
  runs.west2 = runs.west1 & (runs.west1 << 1);
  runs.west4 = runs.west2 & (runs.west2 << 2);
  runs.east1 = moves[0];
  runs.east2 = runs.east1 & (runs.east1 >> 1);
  runs.east4 = runs.east2 & (runs.east2 >> 2);
  return runs;
}

template <int kLanes>
inline void SpreadMasked(Row& row, TileMask from_west, TileMask from_east, int at) {
  Row west, east;
  FromWest<kLanes>(row, west);
  FromEast<kLanes>(row, east);
  LowerTo(row, west + kLanes * kStraightStep, from_west, at);
  LowerTo(row, east + kLanes * kStraightStep, from_east, at);
}

inline void SpreadMasked(Row& row, const Runs& runs, int at) {
  SpreadMasked<1>(row, runs.west1, runs.east1, at);
  SpreadMasked<2>(row, runs.west2, runs.east2, at);
  SpreadMasked<4>(row, runs.west4, runs.east4, at);
}

/// `south`: the direction towards `beside`, 6, or 2 for the north; its diagonals are the ones beside it.
inline void StepMasked(Row& row, const Row& beside, const TileMoves& moves, int towards, int at) {
  LowerTo(row, beside + kStraightStep, moves[static_cast<std::size_t>(towards)], at);
  const auto west_way = static_cast<std::size_t>(towards == 6 ? 5 : 3),
             east_way = static_cast<std::size_t>(towards == 6 ? 7 : 1);
  if (((moves[west_way] | moves[east_way]) >> (8 * at) & 0xff) == 0) return;
  Row west, east;
  FromWest<1>(beside, west);
  FromEast<1>(beside, east);
  LowerTo(row, west + kDiagonalStep, moves[west_way], at);
  LowerTo(row, east + kDiagonalStep, moves[east_way], at);
}

inline bool AnyLess(const Row& a, const Row& b) {
  const Row less = a < b;
  std::array<std::uint64_t, 4> words{};
  std::memcpy(words.data(), &less, sizeof less);
  return (words[0] | words[1] | words[2] | words[3]) != 0;
}

/// Down and up until nothing changes any more.
inline void SweepMasked(Row* rows, const TileMoves& moves) {
  const Runs runs = RunsOf(moves);
  for (int i = 0; i < kTileSide; ++i) {
    if (i > 0) StepMasked(rows[i], rows[i - 1], moves, 6, i);
    SpreadMasked(rows[i], runs, i);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (int i = kTileSide - 1; i-- > 0;) {
      const Row before = rows[i];
      StepMasked(rows[i], rows[i + 1], moves, 2, i);
      if (!AnyLess(rows[i], before)) continue;
      SpreadMasked(rows[i], runs, i);
      changed = true;
    }
    if (!changed) return;
    changed = false;
    for (int i = 1; i < kTileSide; ++i) {
      const Row before = rows[i];
      StepMasked(rows[i], rows[i - 1], moves, 6, i);
      if (!AnyLess(rows[i], before)) continue;
      SpreadMasked(rows[i], runs, i);
      changed = true;
    }
  }
}

inline TileMask Changed(const Row* rows, const Row* before) {
  TileMask changed = 0;
  for (int i = 0; i < kTileSide; ++i) {
    const Row bits = (rows[i] < before[i]) & kLaneBits;
    LatticeDistance byte = 0;
    for (int lane = 0; lane < kTileSide; ++lane) byte |= bits[lane];
    changed |= static_cast<TileMask>(byte) << (8 * i);
  }
  return changed;
}

}  // namespace

TileMoves OpenMoves(bool diagonal) {
  TileMoves moves{};
  for (int cell = 0; cell < kTileSide * kTileSide; ++cell) {
    for (int d = 0; d < kDirections; d += diagonal ? 1 : 2) {
      const int column = cell % kTileSide + kStepColumns[static_cast<std::size_t>(d)];
      const int row = cell / kTileSide + kStepRows[static_cast<std::size_t>(d)];
      if (column < 0 || column >= kTileSide || row < 0 || row >= kTileSide) continue;
      moves[static_cast<std::size_t>(d)] |= TileMask{1} << cell;
    }
  }
  return moves;
}

TileMoves MovesWithin(const TileMoves& moves, TileMask cells) {
  TileMoves within{};
  for (std::size_t d = 0; d < kDirections; ++d) {
    const int offset = kTileSide * kStepRows[d] + kStepColumns[d];
    const TileMask from = offset > 0 ? cells >> offset : cells << -offset;
    within[d] = moves[d] & cells & from;
  }
  return within;
}

TAUTLINE_WIDE_VECTORS
TileMask RelaxTile(const TileMoves& moves, bool open, bool diagonal, TileDistances& distances) {
  Row rows[kTileSide], before[kTileSide];
  std::memcpy(rows, distances.at.data(), sizeof rows);
  std::memcpy(before, rows, sizeof rows);
  if (open) {
    SweepOpen(rows, diagonal);
  } else {
    SweepMasked(rows, moves);
  }
  std::memcpy(distances.at.data(), rows, sizeof rows);
  return Changed(rows, before);
}

}  // namespace tautline
