// Kept manifolds: whatever the content says, it is refused or gives a manifold that answers or finds a fault in itself.
// The input is what follows the question that the manifold answers; that, name, version and checksum are put in front,
// so that it is always read.
#include <boost/crc.hpp>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fuzz/check_answer.h"
#include "tautline/geometry/grid_sketch.h"
#include "tautline/planners/grid_manifold/manifold_file.h"
#include "tautline/planners/grid_manifold/manifold_goal_field.h"
#include "tautline/planners/grid_manifold/manifold_sheets.h"

namespace {

using namespace tautline;

/// The ground that the seeds of the corpus were made for: more than one tile.
CellGround SeedGround() {
  return {GridFromSketch({"...........", ".##....#...", "...........", "....##.....", "...........", ".#......##.",
                          "...........", ".....#.....", "..........."}),
          {}};
}

/// A file with this content, as ManifoldFile::Write puts them together.
std::string FileWith(std::string_view content, const ManifoldOptions& options) {
  constexpr std::size_t kQuestionBytes = 69;  // World, size, cell, origin, angle, length, cells, base, connectivity.
  const std::string whole = ManifoldFile::Write(GridManifold::Build(SeedGround(), options), 7);
  const std::size_t second_line = whole.find('\n') + 1, body = whole.find('\n', second_line) + 1;
  const std::string forged = whole.substr(body, kQuestionBytes) + std::string(content);
  boost::crc_32_type crc;
  crc.process_bytes(forged.data(), forged.size());
  return whole.substr(0, second_line) + std::to_string(crc.checksum()) + "\n" + forged;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ManifoldOptions options{.base = {0, 0}, .length_m = 9};
  const std::string bytes = FileWith({reinterpret_cast<const char*>(data), size}, options);
  const auto manifold = ManifoldFile::Read(bytes, 7, SeedGround(), options);
  fuzz::CheckAnswer(manifold);
  if (!manifold) return 0;
  try {
    static_cast<void>(manifold->Count());
    static_cast<void>(SheetsOf(*manifold, 5));
    const ManifoldGoalField field(*manifold, {7, 6});
    static_cast<void>(field.WayFrom(manifold->base_vertex()));
  } catch (const std::logic_error&) {
    // Distances are not looked at again; where they are forged, a way along them leads nowhere and says so.
  }
  return 0;
}
