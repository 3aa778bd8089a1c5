// Prepared maps: whatever the content says, it is refused or gives a planner that plans or finds a fault in itself. The
// input is the content alone; name, version and checksum are put in front, so that it is always read.
#include <boost/crc.hpp>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fuzz/check_answer.h"
#include "tautline/planners/tether/prepared_file.h"

namespace {

using namespace tautline;

/// The world that the seeds of the corpus were prepared from.
World SeedWorld() {
  World world;
  world.outline = {{0, 0}, {8, 0}, {8, 5}, {0, 5}};
  world.obstacles = {{.name = "a", .polygon = PolygonWithHoles{{{2, 1}, {3, 1}, {3, 3}, {2, 3}}, {}}},
                     {.name = "b", .polygon = PolygonWithHoles{{{5, 2}, {6, 4}, {4, 4}}, {}}}};
  world.clearance = 0.1;
  return world;
}

/// A prepared map with this content, as PreparedFile::Write puts them together.
std::string WithChecksum(std::string_view content) {
  static constexpr std::string_view kFirstLine = "tautline prepared world, version 1\n";
  boost::crc_32_type crc;
  crc.process_bytes(content.data(), content.size());
  return std::string(kFirstLine) + std::to_string(crc.checksum()) + "\n" + std::string(content);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = WithChecksum({reinterpret_cast<const char*>(data), size});
  const auto planner = PreparedFile::Read(bytes, SeedWorld());
  fuzz::CheckAnswer(planner);
  if (!planner) return 0;
  try {
    const Tether tether{{1, 1}, 12, Polyline{{1, 1}, {1, 4}, {3.5, 4.5}}};
    static_cast<void>(planner->Plan(tether, {7, 1}, {.all = true, .budget = 2000}));
  } catch (const std::logic_error&) {
    // What corners see is not looked at again; where it is forged, a plan along it leaves the free ground and says so.
  }
  return 0;
}
