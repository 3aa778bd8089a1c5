#include "tautline/scene/world_digest.h"

#include <boost/crc.hpp>
#include <string_view>

#include "tautline/base/double_bits.h"

namespace tautline {
namespace {

/// CRC-64/XZ over a sequence of numbers and texts, each with its length, so that no two sequences read the same.
class Digest {
 public:
  void Add(std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) crc_.process_byte(static_cast<unsigned char>(value >> shift));
  }
  void Add(double value) { Add(DoubleBits(value)); }
  void Add(Point p) {
    Add(p.x);
    Add(p.y);
  }
  void Add(std::string_view text) {
    Add(std::uint64_t{text.size()});
    crc_.process_bytes(text.data(), text.size());
  }
  void Add(const Ring& ring) {
    Add(std::uint64_t{ring.size()});
    for (const Point p : ring) Add(p);
  }
  void Add(const Obstacle& obstacle) {
    const std::string_view name = obstacle.name;
    Add(name);
    Add(static_cast<std::uint64_t>(obstacle.polygon.has_value()));
    if (obstacle.polygon) {
      Add(obstacle.polygon->outer);
      Add(static_cast<std::uint64_t>(obstacle.polygon->holes.size()));
      for (const Ring& hole : obstacle.polygon->holes) Add(hole);
    }
    Add(static_cast<std::uint64_t>(obstacle.circle.has_value()));
    if (obstacle.circle) {
      Add(obstacle.circle->centre);
      Add(obstacle.circle->radius);
    }
    Add(static_cast<std::uint64_t>(obstacle.representative.has_value()));
    if (obstacle.representative) Add(*obstacle.representative);
  }

  std::uint64_t value() const { return crc_.checksum(); }

 private:
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true> crc_;
};

}  // namespace

std::uint64_t WorldDigest(const World& world) {
  Digest digest;
  digest.Add(world.outline);
  digest.Add(std::uint64_t{world.obstacles.size()});
  for (const Obstacle& obstacle : world.obstacles) digest.Add(obstacle);
  digest.Add(world.clearance);
  digest.Add(world.snap);
  return digest.value();
}

std::uint64_t WorkspaceDigest(const Scene& scene) {
  Digest digest;
  digest.Add(WorldDigest(scene.world));
  digest.Add(scene.tasks);
  digest.Add(std::uint64_t{scene.futures.size()});
  for (const Future& future : scene.futures) {
    digest.Add(future.probability);
    digest.Add(std::uint64_t{future.moves.size()});
    for (const ObstacleMove& move : future.moves) {
      const std::string_view name = move.obstacle;
      digest.Add(name);
      digest.Add(move.path);
    }
  }
  return digest.value();
}

}  // namespace tautline
