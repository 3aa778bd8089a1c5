#include "tautline/planners/grid_manifold/manifold_file.h"

#include <boost/crc.hpp>
#include <stdexcept>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/base/double_bits.h"
#include "tautline/planners/grid_manifold/manifold_builder.h"

namespace tautline {
namespace {

/// Raised whenever what is written, or what it means, changes.
constexpr int kVersion = 2;
constexpr std::string_view kName = "tautline manifold, version ";

std::uint32_t Checksum(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// Integers as bytes, least first.
class ByteWriter {
 public:
  void Add(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  }
  std::string Take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what ByteWriter wrote; throws std::out_of_range at the end.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  std::uint64_t Take(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= std::uint64_t{static_cast<unsigned char>(bytes_.at(at_++))} << (8 * i);
    return value;
  }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// All that the manifold depends on besides the ground and its own budget.
void AddQuestion(std::uint64_t world, const CellGround& ground, const ManifoldOptions& options, ByteWriter& out) {
  out.Add(world, 8);
  const OccupancyGrid& grid = ground.grid();
  out.Add(static_cast<std::uint64_t>(grid.columns), 4);
  out.Add(static_cast<std::uint64_t>(grid.rows), 4);
  for (const double value : {grid.cell_m, grid.origin.x, grid.origin.y, grid.yaw_rad, options.length_m}) {
    out.Add(DoubleBits(value), 8);
  }
  boost::crc_32_type cells;
  cells.process_bytes(grid.cells.data(), grid.cells.size());
  out.Add(cells.checksum(), 4);
  out.Add(static_cast<std::uint64_t>(options.base.column), 4);
  out.Add(static_cast<std::uint64_t>(options.base.row), 4);
  out.Add(options.connectivity == Connectivity::kEight ? 8 : 4, 1);
}

}  // namespace

/// The parts of a manifold that the file holds.
class ManifoldFileContent {
 public:
  static void Write(const GridManifold& manifold, ByteWriter& out) {
    out.Add(static_cast<std::uint64_t>(manifold.stop_), 1);
    out.Add(static_cast<std::uint64_t>(manifold.complete_up_to_), 4);
    out.Add(manifold.words_.size(), 4);
    for (WordTrie::WordNumber word = 1; word < manifold.words_.size(); ++word) {
      out.Add(manifold.words_.parent(word), 4);
      out.Add(static_cast<std::uint64_t>(manifold.words_.last(word)), 4);
    }
    out.Add(manifold.page_count_, 4);
    for (std::uint32_t page = 0; page < manifold.page_count_; ++page) {
      out.Add(manifold.pages_[page].patch, 4);
      out.Add(manifold.pages_[page].word, 4);
      const int count = manifold.atlas_.shape(manifold.patch(page)).count;
      for (int i = 0; i < count; ++i) {
        const LatticeDistance value = manifold.values_[manifold.first_value(page) + static_cast<std::size_t>(i)];
        out.Add(static_cast<std::uint64_t>(value), 4);
      }
    }
  }

  /// Throws std::logic_error where something cannot be.
  static void Read(ByteReader& in, const ManifoldOptions& options, GridManifold& manifold) {
    const std::uint64_t stop = in.Take(1);
    TAUTLINE_CHECK(stop <= static_cast<std::uint64_t>(ManifoldStop::kDistance));
    const auto complete = static_cast<LatticeDistance>(in.Take(4));
    TAUTLINE_CHECK(complete >= 0 && complete <= manifold.limit_ + 1);
    ReadWords(in, manifold);
    ManifoldBuilder builder(manifold, options);
    const std::uint64_t pages = in.Take(4);
    for (std::uint64_t i = 0; i < pages; ++i) ReadPage(in, builder, manifold);
    TAUTLINE_CHECK(manifold.page_count_ == pages && pages > 0 && in.left() == 0);
    builder.Adopt(static_cast<ManifoldStop>(stop), complete);
    TAUTLINE_CHECK(manifold.Has(manifold.base_vertex()) && manifold.distance(manifold.base_vertex()) == 0);
    manifold.IndexPages();
  }

 private:
  static void ReadWords(ByteReader& in, GridManifold& manifold) {
    const std::uint64_t words = in.Take(4);
    const auto letters = 2 * static_cast<std::int64_t>(manifold.ground_.names().size());
    for (std::uint64_t word = 1; word < words; ++word) {
      const std::uint64_t parent = in.Take(4);
      const auto letter = static_cast<TrieLetter>(in.Take(4));
      TAUTLINE_CHECK(parent < word && letter >= 0 && letter < letters);
      TAUTLINE_CHECK(manifold.words_.Append(static_cast<WordTrie::WordNumber>(parent), letter) == word);
    }
  }

  static void ReadPage(ByteReader& in, ManifoldBuilder& builder, GridManifold& manifold) {
    const std::uint64_t patch = in.Take(4), word = in.Take(4);
    TAUTLINE_CHECK(patch < manifold.atlas_.size() && word < manifold.words_.size());
    const auto number = static_cast<PatchAtlas::PatchNumber>(patch);
    const std::uint32_t page = builder.Obtain(number, static_cast<WordTrie::WordNumber>(word));
    const int count = manifold.atlas_.shape(number).count;
    for (int i = 0; i < count; ++i) {
      const auto value = static_cast<LatticeDistance>(in.Take(4));
      TAUTLINE_CHECK(value == kUnreached || (value >= 0 && value <= manifold.limit_));
      manifold.values_[manifold.first_value(page) + static_cast<std::size_t>(i)] = value;
    }
  }
};

std::string ManifoldFile::Write(const GridManifold& manifold, std::uint64_t world) {
  ByteWriter out;
  AddQuestion(
      world, manifold.ground(),
      {.base = manifold.base(), .length_m = manifold.length_m(), .connectivity = manifold.atlas().connectivity()}, out);
  ManifoldFileContent::Write(manifold, out);
  const std::string body = out.Take();
  return std::string(kName) + std::to_string(kVersion) + "\n" + std::to_string(Checksum(body)) + "\n" + body;
}

Expected<GridManifold> ManifoldFile::Read(std::string_view bytes, std::uint64_t world, CellGround ground,
                                          const ManifoldOptions& options) {
  if (!bytes.starts_with(kName)) return InvalidInput("not a manifold: make one with --save-prepared");
  bytes.remove_prefix(kName.size());
  const std::string version = std::to_string(kVersion) + "\n";
  if (!bytes.starts_with(version)) {
    return InvalidInput("a manifold of another version of tautline: make it anew with --save-prepared");
  }
  bytes.remove_prefix(version.size());
  const auto damaged = [] { return InvalidInput("the manifold is damaged: make it anew with --save-prepared"); };
  const std::size_t line = bytes.find('\n');
  if (line == std::string_view::npos) return damaged();
  const std::string_view body = bytes.substr(line + 1);
  if (bytes.substr(0, line) != std::to_string(Checksum(body))) return damaged();
  ByteWriter question;
  AddQuestion(world, ground, options, question);
  const std::string asked = question.Take();
  if (!body.starts_with(asked)) {
    return InvalidInput(
        "the manifold was made for another world, base, length, resolution or connectivity: make it anew with "
        "--save-prepared");
  }
  try {
    GridManifold manifold(std::move(ground), options);
    ByteReader in(body.substr(asked.size()));
    ManifoldFileContent::Read(in, options, manifold);
    return manifold;
  } catch (const std::logic_error&) {  // Also std::out_of_range: the checksum guards against accidents only.
    return damaged();
  }
}

}  // namespace tautline
