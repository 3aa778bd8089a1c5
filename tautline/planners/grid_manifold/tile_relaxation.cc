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

/// Without walls a shortest way is straight east or west first and then all north or all south: one pass does.
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

/// Row by row what is given column by column.
constexpr TileMask Transposed(TileMask cells) {
  TileMask swap = (cells ^ (cells >> 7)) & 0x00aa00aa00aa00aaULL;
  cells ^= swap ^ (swap << 7);
  swap = (cells ^ (cells >> 14)) & 0x0000cccc0000ccccULL;
  cells ^= swap ^ (swap << 14);
  swap = (cells ^ (cells >> 28)) & 0x00000000f0f0f0f0ULL;
  return cells ^ swap ^ (swap << 28);
}

/// The cells of a tile of which bit i of lane k tells about the one in row i and column k.
inline TileMask FromColumns(const Row& columns) {
  std::array<LatticeDistance, kTileSide> lanes{};
  std::memcpy(lanes.data(), &columns, sizeof columns);
  TileMask cells = 0;
  for (std::size_t i = 0; i < lanes.size(); ++i) cells |= static_cast<TileMask>(lanes[i]) << (8 * i);
  return Transposed(cells);
}

inline TileMask Changed(const Row* rows, const Row* before) {
  Row columns{};
  for (int i = 0; i < kTileSide; ++i) columns |= (rows[i] < before[i]) & (1 << i);
  return FromColumns(columns);
}

/// The distances of a column of a tile, the lowest first.
inline void LoadColumn(const LatticeDistance* tile, int column, Row& result) {
  std::array<LatticeDistance, kTileSide> lanes{};
  for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = tile[8 * i + static_cast<std::size_t>(column)];
  std::memcpy(&result, lanes.data(), sizeof result);
}

inline void StoreColumn(const Row& row, int column, LatticeDistance* tile) {
  std::array<LatticeDistance, kTileSide> lanes{};
  std::memcpy(lanes.data(), &row, sizeof row);
  for (std::size_t i = 0; i < lanes.size(); ++i) tile[8 * i + static_cast<std::size_t>(column)] = lanes[i];
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

TAUTLINE_WIDE_VECTORS
TileMask ReachedCells(const LatticeDistance* distances) {
  Row columns{};
  for (int i = 0; i < kTileSide; ++i, distances += kTileSide) {
    Row row;
    std::memcpy(&row, distances, sizeof row);
    columns |= (row < kFar) & (1 << i);
  }
  return FromColumns(columns);
}

TAUTLINE_WIDE_VECTORS
HandedOn HandAcross(int side, bool diagonal, LatticeDistance limit, const LatticeDistance* from, LatticeDistance* to) {
  const bool level = side % 4 == 0;  // East or west: the lanes are those of a column.
  const int near = side == 0 || side == 2 ? kTileSide - 1 : 0, beyond = kTileSide - 1 - near;
  const int near_row = kTileSide * near, beyond_row = kTileSide * beyond;
  Row beside, offers = kFar, values;
  if (level) {
    LoadColumn(from, near, beside);
    LoadColumn(to, beyond, values);
  } else {
    std::memcpy(&beside, from + near_row, sizeof beside);
    std::memcpy(&values, to + beyond_row, sizeof values);
  }
  StepOpen(offers, beside, diagonal);
  const Row lower = (offers < values) & (offers <= limit);
  const Row lowered = lower ? offers : values;
  if (!AnyLess(lowered, values)) return {};
  if (level) {
    StoreColumn(lowered, beyond, to);
  } else {
    std::memcpy(to + beyond_row, &lowered, sizeof lowered);
  }
  HandedOn result;
  const Row least = lower ? offers : kFar;
  for (int i = 0; i < kTileSide; ++i) {
    const auto bit = static_cast<TileMask>(lower[i] & 1);
    result.lowered |= bit << (level ? kTileSide * i + beyond : kTileSide * beyond + i);
    result.least = least[i] < result.least ? least[i] : result.least;
  }
  return result;
}

}  // namespace tautline
