// How a manifold is built: pages in order of distance, each swept as a whole.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_BUILDER_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_BUILDER_H_

#include <array>
#include <vector>

#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// Pages wait in buckets one step wide, by the least distance that they have not handed on yet. All pages of a bucket
/// are swept, each on its own; then all hand their changed distances on, which lie in later buckets. So a distance is
/// final once its bucket is done, and nothing depends on the order within a bucket.
class ManifoldBuilder {
 public:
  ManifoldBuilder(GridManifold& manifold, const ManifoldOptions& options);

  /// Everything.
  void Build();

  /// The page of a patch with a word, which is made where it is new, with nothing reached.
  std::uint32_t Obtain(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word);
  /// Takes the distances of all pages as final: those that a file held.
  void Adopt(ManifoldStop stop, LatticeDistance complete_up_to);

 private:
  using Page = GridManifold::Page;
  /// Tiles of one colour have no neighbours in common; pages of one tile are in one share of a colour, so that no two
  /// threads write to one page.
  static constexpr std::size_t kColours = 9;
  static constexpr std::size_t kShares = 32;
  static constexpr LatticeDistance kBucket = kStraightStep;

  void AddBase();
  void TakeBatch(std::size_t bucket);
  void RunBatch();
  void HandOnInColours();
  void InRanges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) const;
  void InThreads(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) const;
  void Sweep(std::size_t at);
  void MakeLinks(std::size_t at);
  void FetchBeside(std::uint32_t number) const;
  void HandOn(std::size_t place);
  void Enqueue(std::size_t at);
  void SetVertices(std::uint32_t number);
  void Queue(std::uint32_t number);
  bool CanCross(const Page& page, const PatchAtlas::Link& link) const;
  std::size_t Slot(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word) const;
  WordTrie::WordNumber WordAcross(WordTrie::WordNumber word, const PatchAtlas::Link& link);
  void RehashPages();
  std::size_t ShareOf(const Page& page) const;

  bool MustStop(std::size_t bucket);
  bool HasTooMany(std::size_t bucket, LatticeDistance done);
  void CutAt(LatticeDistance distance);
  void Finish();
  void FindLinks(std::uint32_t number);

  GridManifold& m_;
  const ManifoldOptions& options_;
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::vector<std::uint32_t> batch_;
  std::vector<std::uint64_t> open_links_;  ///< By place in the batch: bits of links that lead to a page yet unknown.
  std::vector<std::uint64_t>
      lowered_links_;  ///< By place in the batch: bits of links across which something got lower.
  std::array<std::vector<std::uint32_t>, kColours * kShares> shares_;
  std::size_t next_check_ = 0;  ///< Values after which the vertices are counted next.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_BUILDER_H_
