// How a manifold is built: pages in order of distance, each swept as a whole.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_BUILDER_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_BUILDER_H_

#include <array>
#include <vector>

#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// Pages wait in buckets by the least distance that they have not handed on yet. In each round some pages of the first
/// bucket are swept, each on its own; then all of them hand their changed distances on, maybe to the same bucket. So a
/// distance is final once its bucket is empty, and nothing depends on which thread does what.
class ManifoldBuilder {
 public:
  /// Builds `manifold`, which is to outlive it, from its base on.
  ManifoldBuilder(GridManifold& manifold, const ManifoldOptions& options);

  /// Everything.
  void Build();

  /// The page of a patch with a word, which is made where it is new; its distances are then to be set.
  std::uint32_t Obtain(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word);
  /// Takes the distances of all pages as final: those that a file held.
  void Adopt(ManifoldStop stop, LatticeDistance complete_up_to);

 private:
  using Page = GridManifold::Page;
  using PageNumber = std::uint32_t;
  /// Blocks of 2 x 2 tiles of one colour have no neighbours in common; pages of one block are in one share of a colour,
  /// so that no two threads write to one page.
  static constexpr std::size_t kColours = 4;
  static constexpr std::size_t kShares = 64;
  /// Narrow enough that pages are hardly ever swept twice, and wide enough for rounds that are worth two threads.
  static constexpr LatticeDistance kBucket = 2 * kStraightStep;

  /// A page that got a distance less than what it waits with.
  struct Waiting {
    PageNumber page = 0;
    std::uint32_t bucket = 0;
  };
  /// A page whose turn it is.
  struct Turn {
    PageNumber page = 0;
    std::uint32_t share = 0;        ///< What part of handing on it belongs to.
    std::uint64_t open_links = 0;   ///< Bits of links that lead to a page yet unknown.
    std::uint64_t fresh_links = 0;  ///< Bits of links whose page does not know of this one.
  };

  void AddBase();
  void TakeBatch(std::size_t bucket);
  void RunBatch();
  void HandOnInColours();
  void SortByShare();
  void InRanges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) const;
  void InThreads(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) const;
  void Sweep(Turn& turn);
  void FollowLinks(Turn& turn);
  void MakeLinks(const Turn& turn);
  void ClearPages(std::size_t first, std::size_t last);
  void FetchValues(PageNumber number) const;
  void FetchPagesBeside(PageNumber number) const;
  void FetchBeside(PageNumber number) const;
  void HandOn(const Turn& turn, std::vector<Waiting>& waiting);
  HandedOn HandAcrossLink(const Page& page, const PatchAtlas::Link& link, const Page& other);
  void LetWait(const std::vector<Waiting>& waiting);
  bool CanCross(const Page& page, const PatchAtlas::Link& link) const;
  std::size_t Slot(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word) const;
  PageNumber Find(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word) const;
  WordTrie::WordNumber FindAcross(WordTrie::WordNumber word, WordTrie::WordNumber change) const;
  WordTrie::WordNumber WordAcross(WordTrie::WordNumber word, WordTrie::WordNumber change);
  void RehashPages();
  std::uint32_t ShareOf(const Page& page) const;

  bool MustStop(std::size_t bucket);
  bool HasTooMany(std::size_t bucket, LatticeDistance done);
  void CutAt(LatticeDistance distance);
  void Finish();
  void FindLinks(PageNumber number);

  GridManifold& m_;
  const ManifoldOptions& options_;
  std::vector<std::vector<PageNumber>> buckets_;
  std::vector<Turn> batch_;
  std::vector<std::uint32_t> order_;  ///< Places in the batch, by share.
  std::array<std::uint32_t, kColours * kShares + 1> first_of_share_{};
  std::array<std::vector<Waiting>, kColours * kShares> waiting_;
  std::size_t next_check_ = 0;  ///< Values after which the vertices are counted next.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_BUILDER_H_
