#include "tautline/planners/grid_manifold/manifold_builder.h"

#include <algorithm>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/grid_manifold/page_values.h"

namespace tautline {
namespace {

constexpr std::uint32_t kNoPage = GridManifold::kNoPage;

/// Pages; fewer are done before another thread wakes up.
constexpr std::size_t kWorthwhile = 64;

/// The bit of a link; the last one stands for all further links, of patches around many islands.
std::uint64_t BitOf(std::size_t link) { return std::uint64_t{1} << std::min<std::size_t>(link, 63); }

}  // namespace

ManifoldBuilder::ManifoldBuilder(GridManifold& manifold, const ManifoldOptions& options)
    : m_(manifold), options_(options) {
  m_.page_table_.assign(64, kNoPage);
  buckets_.resize(static_cast<std::size_t>(m_.limit_ / kBucket) + 1);
}

void ManifoldBuilder::Build() {
  AddBase();
  m_.complete_up_to_ = m_.limit_ + 1;
  for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
    TakeBatch(bucket);
    if (batch_.empty()) continue;
    RunBatch();
    if (MustStop(bucket)) break;
  }
  Finish();
}

void ManifoldBuilder::Adopt(ManifoldStop stop, LatticeDistance complete_up_to) {
  m_.stop_ = stop;
  m_.complete_up_to_ = complete_up_to;
  Finish();
}

void ManifoldBuilder::AddBase() {
  const PatchAtlas::Place place = m_.atlas_.PlaceOf(m_.base_);
  // The word of the base itself is empty, so that of its patch undoes the word of its cell.
  WordTrie::WordNumber word = WordTrie::kEmpty;
  const WordTrie& words = m_.atlas_.words();
  for (auto w = m_.atlas_.WordOf(place); w != WordTrie::kEmpty; w = words.parent(w)) {
    word = m_.words_.Append(word, words.last(w) ^ 1);
  }
  Page& page = m_.pages_[Obtain(place.patch, word)];
  m_.values_[page.first_value + m_.atlas_.shape(place.patch).position[static_cast<std::size_t>(place.cell)]] = 0;
  page.cells = TileMask{1} << place.cell;
  page.key = 0;
  Queue(0);
}

void ManifoldBuilder::InRanges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) const {
  if (count >= kWorthwhile) return InThreads(count, work);
  work(0, count);
}

void ManifoldBuilder::InThreads(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) const {
  if (options_.parallel) return options_.parallel(count, work);
  work(0, count);
}

/// The pages whose turn it is. Those that came to wait elsewhere with a lower key are left out.
void ManifoldBuilder::TakeBatch(std::size_t bucket) {
  batch_.clear();
  for (const std::uint32_t number : buckets_[bucket]) {
    Page& page = m_.pages_[number];
    if (static_cast<std::size_t>(page.key / kBucket) != bucket) continue;
    page.key = kUnreached;
    batch_.push_back(number);
  }
  std::vector<std::uint32_t>().swap(buckets_[bucket]);
}

void ManifoldBuilder::RunBatch() {
  open_links_.assign(batch_.size(), 0);
  lowered_links_.assign(batch_.size(), 0);
  InRanges(batch_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) Sweep(i);
  });
  for (std::size_t i = 0; i < batch_.size(); ++i) MakeLinks(i);
  // In the same order with one thread as with many: what a page hands on depends on what it was handed just before.
  if (batch_.size() >= kWorthwhile) {
    HandOnInColours();
  } else {
    for (std::size_t i = 0; i < batch_.size(); ++i) {
      if (i + 2 < batch_.size()) FetchBeside(batch_[i + 2]);
      HandOn(i);
    }
  }
  for (std::size_t i = 0; i < batch_.size(); ++i) Enqueue(i);
}

void ManifoldBuilder::HandOnInColours() {
  for (auto& share : shares_) share.clear();
  for (std::uint32_t i = 0; i < batch_.size(); ++i) shares_[ShareOf(m_.pages_[batch_[i]])].push_back(i);
  for (std::size_t colour = 0; colour < kColours; ++colour) {
    InThreads(kShares, [&](std::size_t begin, std::size_t end) {
      for (std::size_t share = begin; share < end; ++share) {
        const auto& places = shares_[colour * kShares + share];
        for (std::size_t i = 0; i < places.size(); ++i) {
          if (i + 2 < places.size()) FetchBeside(batch_[places[i + 2]]);
          HandOn(places[i]);
        }
      }
    });
  }
}

std::size_t ManifoldBuilder::ShareOf(const Page& page) const {
  const GridCell corner = m_.atlas_.CellOf({page.patch, 0});
  const auto column = static_cast<std::size_t>(corner.column / kTileSide),
             row = static_cast<std::size_t>(corner.row / kTileSide);
  return (column % 3 + 3 * (row % 3)) * kShares + (column / 3 + 7 * (row / 3)) % kShares;
}

void ManifoldBuilder::Sweep(std::size_t at) {
  Page& page = m_.pages_[batch_[at]];
  const PatchAtlas::Shape& shape = m_.atlas_.shape(page.patch);
  LatticeDistance* values = &m_.values_[page.first_value];
  TileDistances tile;
  LoadTile(shape, values, tile);
  page.cells |= RelaxTile(shape.moves, shape.open, m_.atlas_.connectivity() == Connectivity::kEight, tile);
  for (std::size_t i = 0; i < tile.at.size(); ++i) tile.at[i] = tile.at[i] > m_.limit_ ? kUnreached : tile.at[i];
  StoreTile(shape, tile, values);
  const auto links = m_.atlas_.links(page.patch);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (m_.links_[page.first_link + i] == kNoPage && CanCross(page, links[i])) open_links_[at] |= BitOf(i);
  }
}

/// Whether a distance of the page leads across the link to one within the limit.
bool ManifoldBuilder::CanCross(const Page& page, const PatchAtlas::Link& link) const {
  const PatchAtlas::Shape& shape = m_.atlas_.shape(page.patch);
  const LatticeDistance* values = &m_.values_[page.first_value];
  for (const PatchAtlas::Crossing& crossing : m_.atlas_.crossings(link)) {
    const LatticeDistance most = m_.limit_ - StepLength(crossing.direction);
    for (TileMask cells = page.cells & crossing.from; cells != 0; cells &= cells - 1) {
      if (values[shape.position[static_cast<std::size_t>(__builtin_ctzll(cells))]] <= most) return true;
    }
  }
  return false;
}

void ManifoldBuilder::MakeLinks(std::size_t at) {
  if (open_links_[at] == 0) return;
  const std::uint32_t number = batch_[at];
  const auto links = m_.atlas_.links(m_.pages_[number].patch);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Page& page = m_.pages_[number];
    if ((open_links_[at] & BitOf(i)) == 0 || m_.links_[page.first_link + i] != kNoPage) continue;
    if (i >= 63 && !CanCross(page, links[i])) continue;
    const std::uint32_t to = Obtain(links[i].to, WordAcross(page.word, links[i]));
    m_.links_[page.first_link + i] = to;
    m_.links_[m_.pages_[to].first_link + links[i].back] = number;
  }
}

WordTrie::WordNumber ManifoldBuilder::WordAcross(WordTrie::WordNumber word, const PatchAtlas::Link& link) {
  if (link.word == WordTrie::kEmpty) return word;
  for (const TrieLetter letter : m_.atlas_.words().LettersOf(link.word)) word = m_.words_.Append(word, letter);
  return word;
}

/// Asks for the memory that handing on will write to, which lies all over.
void ManifoldBuilder::FetchBeside(std::uint32_t number) const {
  constexpr std::size_t kLine = 16;  // Distances.
  const Page& page = m_.pages_[number];
  const std::size_t links = m_.atlas_.links(page.patch).size();
  for (std::size_t i = 0; i < links; ++i) {
    const std::uint32_t to = m_.links_[page.first_link + i];
    if (to == kNoPage) continue;
    const Page& other = m_.pages_[to];
    const std::size_t count = m_.atlas_.shape(other.patch).count;
    for (std::size_t at = 0; at < count; at += kLine) __builtin_prefetch(&m_.values_[other.first_value + at], 1);
  }
}

/// Offers the changed distances of a page to the pages beside it.
void ManifoldBuilder::HandOn(std::size_t place) {
  Page& page = m_.pages_[batch_[place]];
  const PatchAtlas::Shape& shape = m_.atlas_.shape(page.patch);
  const LatticeDistance* values = &m_.values_[page.first_value];
  const auto links = m_.atlas_.links(page.patch);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::uint32_t to = m_.links_[page.first_link + i];
    if (to == kNoPage) continue;
    Page& other = m_.pages_[to];
    const PatchAtlas::Shape& other_shape = m_.atlas_.shape(other.patch);
    LatticeDistance* others = &m_.values_[other.first_value];
    for (const PatchAtlas::Crossing& crossing : m_.atlas_.crossings(links[i])) {
      const LatticeDistance step = StepLength(crossing.direction);
      for (TileMask cells = page.cells & crossing.from; cells != 0; cells &= cells - 1) {
        const int cell = __builtin_ctzll(cells), beside = cell + crossing.offset;
        const LatticeDistance offer = values[shape.position[static_cast<std::size_t>(cell)]] + step;
        LatticeDistance& value = others[other_shape.position[static_cast<std::size_t>(beside)]];
        if (offer >= value || offer > m_.limit_) continue;
        value = offer;
        other.cells |= TileMask{1} << beside;
        other.key = std::min(other.key, offer);
        lowered_links_[place] |= BitOf(i);
      }
    }
  }
  // What other pages have offered to it meanwhile, it hands on when its turn comes.
  if (page.key == kUnreached) page.cells = 0;
}

/// Lets the pages beside a page wait with their new keys.
void ManifoldBuilder::Enqueue(std::size_t at) {
  if (lowered_links_[at] == 0) return;
  const Page& page = m_.pages_[batch_[at]];
  const std::size_t links = m_.atlas_.links(page.patch).size();
  for (std::size_t i = 0; i < links; ++i) {
    if ((lowered_links_[at] & BitOf(i)) == 0) continue;
    const std::uint32_t to = m_.links_[page.first_link + i];
    if (to != kNoPage) Queue(to);
  }
}

void ManifoldBuilder::Queue(std::uint32_t number) {
  Page& page = m_.pages_[number];
  if (page.key == kUnreached || page.key == page.queued) return;
  page.queued = page.key;
  buckets_[static_cast<std::size_t>(page.key / kBucket)].push_back(number);
}

std::size_t ManifoldBuilder::Slot(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word) const {
  const std::size_t mask = m_.page_table_.size() - 1;
  std::uint64_t key = ((std::uint64_t{patch} << 32) | word) * 0x9e3779b97f4a7c15ULL;
  std::size_t slot = static_cast<std::size_t>(key >> 24) & mask;
  while (m_.page_table_[slot] != kNoPage) {
    const Page& page = m_.pages_[m_.page_table_[slot]];
    if (page.patch == patch && page.word == word) break;
    slot = (slot + 1) & mask;
  }
  return slot;
}

std::uint32_t ManifoldBuilder::Obtain(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word) {
  const std::size_t slot = Slot(patch, word);
  if (m_.page_table_[slot] != kNoPage) return m_.page_table_[slot];
  const std::size_t first_value = m_.values_.Grow(m_.atlas_.shape(patch).count, kUnreached);
  const std::size_t first_link = m_.links_.Grow(m_.atlas_.links(patch).size(), kNoPage);
  TAUTLINE_CHECK(first_value < kNoPage && first_link < kNoPage);
  const auto number = static_cast<std::uint32_t>(m_.pages_.Grow(1, {}));
  Page& page = m_.pages_[number];
  page.word = word;
  page.patch = patch;
  page.first_value = static_cast<std::uint32_t>(first_value);
  page.first_link = static_cast<std::uint32_t>(first_link);
  m_.page_table_[slot] = number;
  m_.page_count_ = std::size_t{number} + 1;
  if (2 * m_.page_count_ > m_.page_table_.size()) RehashPages();
  return number;
}

void ManifoldBuilder::RehashPages() {
  m_.page_table_.assign(2 * m_.page_table_.size(), kNoPage);
  for (std::uint32_t page = 0; page < m_.page_count_; ++page) {
    m_.page_table_[Slot(m_.pages_[page].patch, m_.pages_[page].word)] = page;
  }
}

/// After a bucket: whether a budget is used up. Then everything at a distance that is not final is cut off, and so much
/// more that the rest is within the budget.
bool ManifoldBuilder::MustStop(std::size_t bucket) {
  const std::int64_t next = (static_cast<std::int64_t>(bucket) + 1) * kBucket;
  if (next > m_.limit_) return false;
  const auto done = static_cast<LatticeDistance>(next);
  if (options_.keep_going && !options_.keep_going()) {
    m_.stop_ = ManifoldStop::kAsked;
  } else if (static_cast<std::int64_t>(m_.bytes()) > options_.max_bytes) {
    m_.stop_ = ManifoldStop::kBytes;
  }
  if (m_.stop_ == ManifoldStop::kNone) return HasTooMany(bucket, done);
  CutAt(done);
  return true;
}

bool ManifoldBuilder::HasTooMany(std::size_t bucket, LatticeDistance done) {
  if (static_cast<std::int64_t>(m_.values_.end()) <= options_.max_vertices || m_.values_.end() < next_check_) {
    return false;
  }
  // Counting goes over all pages, so it is done only when there may be a tenth more.
  next_check_ = m_.values_.end() + m_.values_.end() / 10;
  std::vector<std::int64_t> by_bucket(bucket + 1);
  for (std::uint32_t page = 0; page < m_.page_count_; ++page) {
    const LatticeDistance* values = &m_.values_[m_.pages_[page].first_value];
    for (int i = 0; i < m_.atlas_.shape(m_.pages_[page].patch).count; ++i) {
      if (values[i] < done) ++by_bucket[static_cast<std::size_t>(values[i] / kBucket)];
    }
  }
  std::int64_t vertices = 0;
  for (std::size_t i = 0; i <= bucket; ++i) {
    vertices += by_bucket[i];
    if (vertices <= options_.max_vertices) continue;
    m_.stop_ = ManifoldStop::kVertices;
    CutAt(static_cast<LatticeDistance>(i) * kBucket);
    return true;
  }
  return false;
}

void ManifoldBuilder::CutAt(LatticeDistance distance) {
  m_.complete_up_to_ = distance;
  for (std::uint32_t page = 0; page < m_.page_count_; ++page) {
    LatticeDistance* values = &m_.values_[m_.pages_[page].first_value];
    for (int i = 0; i < m_.atlas_.shape(m_.pages_[page].patch).count; ++i) {
      if (values[i] >= distance) values[i] = kUnreached;
    }
  }
}

/// The vertices of each page, and the links that nothing went across.
void ManifoldBuilder::Finish() {
  InRanges(m_.page_count_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t page = begin; page < end; ++page) {
      SetVertices(static_cast<std::uint32_t>(page));
      FindLinks(static_cast<std::uint32_t>(page));
    }
  });
  if (m_.stop_ != ManifoldStop::kNone || m_.length_m_ <= kFarthestCells * m_.ground_.cell_m()) return;
  for (std::uint32_t page = 0; page < m_.page_count_; ++page) {
    const LatticeDistance* values = &m_.values_[m_.pages_[page].first_value];
    for (int i = 0; i < m_.atlas_.shape(m_.pages_[page].patch).count; ++i) {
      if (values[i] != kUnreached && values[i] > m_.limit_ - kDiagonalStep) m_.stop_ = ManifoldStop::kDistance;
    }
  }
}

void ManifoldBuilder::SetVertices(std::uint32_t number) {
  Page& page = m_.pages_[number];
  TileDistances tile;
  LoadTile(m_.atlas_.shape(page.patch), &m_.values_[page.first_value], tile);
  page.cells = 0;
  for (std::size_t i = 0; i < tile.at.size(); ++i) {
    page.cells |= static_cast<TileMask>(tile.at[i] != kUnreached) << i;
  }
}

void ManifoldBuilder::FindLinks(std::uint32_t number) {
  const Page& page = m_.pages_[number];
  const auto links = m_.atlas_.links(page.patch);
  for (std::size_t i = 0; i < links.size(); ++i) {
    std::uint32_t& to = m_.links_[page.first_link + i];
    if (to != kNoPage) continue;
    WordTrie::WordNumber word = page.word;
    if (links[i].word != WordTrie::kEmpty) {
      for (const TrieLetter letter : m_.atlas_.words().LettersOf(links[i].word)) {
        if (word != WordTrie::kMissing) word = m_.words_.Find(word, letter);
      }
    }
    if (word != WordTrie::kMissing) to = m_.page_table_[Slot(links[i].to, word)];
  }
}

}  // namespace tautline
