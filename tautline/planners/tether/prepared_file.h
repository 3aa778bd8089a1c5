// A prepared map as bytes: made once, loaded where it is used.
#ifndef TAUTLINE_PLANNERS_TETHER_PREPARED_FILE_H_
#define TAUTLINE_PLANNERS_TETHER_PREPARED_FILE_H_

#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {

/// Writes and reads the free space of a planner and what its corners see. The bytes are a line that names the format
/// and its version, the checksum of the rest, and CBOR [RFC 8949]; the same on every machine.
class PreparedFile {
 public:
  /// The preparation of `world`, which must be the one that the planner was prepared with. O(size).
  static std::string Write(const TetherPlanner& planner, const World& world);

  /// The planner that was written, ready at once: only its triangulation is built anew. Errors: not such a file, of
  /// another version, damaged, or made for a world other than `world`. O(n log n) for n boundary vertices; about a
  /// tenth of Prepare.
  [[nodiscard]] static Expected<TetherPlanner> Read(std::string_view bytes, const World& world);
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_PREPARED_FILE_H_
