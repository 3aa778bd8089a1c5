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

/// Pages of a round: as many as stay in a processor's own memory until they hand on.
constexpr std::size_t kBatch = 1024;

/// Distances in a line of memory.
constexpr std::size_t kLine = 16;

/// The bit of a link; the last one stands for all further links, of patches around many islands.
std::uint64_t BitOf(std::size_t link) { return std::uint64_t{1} << std::min<std::size_t>(link, 63); }

}  // namespace

ManifoldBuilder::ManifoldBuilder(GridManifold& manifold, const ManifoldOptions& options)
    : m_(manifold), options_(options) {
  // Most patches within reach get a page, in open ground hardly more than one.
  std::size_t slots = 64;
  while (slots < 2 * m_.atlas_.size()) slots *= 2;
  m_.page_table_.assign(slots, kNoPage);
  buckets_.resize(static_cast<std::size_t>(m_.limit_ / kBucket) + 1);
}

void ManifoldBuilder::Build() {
  AddBase();
  m_.complete_up_to_ = m_.limit_ + 1;
  for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
    if (buckets_[bucket].empty()) continue;
    while (!buckets_[bucket].empty()) {
      TakeBatch(bucket);
      RunBatch();
    }
    std::vector<PageNumber>().swap(buckets_[bucket]);
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
  ClearPages(0, 1);
  m_.values_[page.first_value + m_.atlas_.shape(place.patch).position[static_cast<std::size_t>(place.cell)]] = 0;
  page.cells = TileMask{1} << place.cell;
  page.key = page.queued = 0;
  buckets_[0].push_back(0);
}

void ManifoldBuilder::InRanges(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) const {
  if (count >= kWorthwhile) return InThreads(count, work);
  work(0, count);
}

void ManifoldBuilder::InThreads(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) const {
  if (options_.parallel) return options_.parallel(count, work);
  work(0, count);
}

/// Pages whose turn it is, the last that came first. Those that came to wait elsewhere with a lower key are left out.
void ManifoldBuilder::TakeBatch(std::size_t bucket) {
  batch_.clear();
  auto& waiting = buckets_[bucket];
  for (; !waiting.empty() && batch_.size() < kBatch; waiting.pop_back()) {
    Page& page = m_.pages_[waiting.back()];
    if (static_cast<std::size_t>(page.key / kBucket) != bucket) continue;
    page.key = page.queued = kUnreached;
    batch_.push_back({.page = waiting.back()});
  }
}

void ManifoldBuilder::RunBatch() {
  InRanges(batch_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + 4 < end) FetchValues(batch_[i + 4].page);
      Sweep(batch_[i]);
    }
  });
  const std::size_t known = m_.page_count_;
  for (const Turn& turn : batch_) MakeLinks(turn);
  InRanges(m_.page_count_ - known, [&](std::size_t begin, std::size_t end) { ClearPages(known + begin, known + end); });
  // In the same order with one thread as with many: what a page hands on depends on what it was handed just before.
  if (batch_.size() >= kWorthwhile) return HandOnInColours();
  for (std::size_t i = 0; i < batch_.size(); ++i) {
    if (i + 2 < batch_.size()) FetchBeside(batch_[i + 2].page);
    HandOn(batch_[i], waiting_[0]);
  }
  LetWait(waiting_[0]);
  waiting_[0].clear();
}

void ManifoldBuilder::HandOnInColours() {
  SortByShare();
  for (std::size_t colour = 0; colour < kColours; ++colour) {
    InThreads(kShares, [&](std::size_t begin, std::size_t end) {
      const std::size_t last = first_of_share_[colour * kShares + end];
      for (std::size_t i = first_of_share_[colour * kShares + begin]; i < last; ++i) {
        if (i + 8 < last) FetchPagesBeside(batch_[order_[i + 8]].page);
        if (i + 4 < last) FetchBeside(batch_[order_[i + 4]].page);
        HandOn(batch_[order_[i]], waiting_[batch_[order_[i]].share]);
      }
    });
  }
  for (auto& waiting : waiting_) {
    LetWait(waiting);
    waiting.clear();
  }
}

/// Lists the batch by share, in each in the order of the batch.
void ManifoldBuilder::SortByShare() {
  first_of_share_.fill(0);
  for (const Turn& turn : batch_) ++first_of_share_[turn.share + 1];
  for (std::size_t i = 1; i < first_of_share_.size(); ++i) first_of_share_[i] += first_of_share_[i - 1];
  auto next = first_of_share_;
  order_.resize(batch_.size());
  for (std::uint32_t i = 0; i < batch_.size(); ++i) order_[next[batch_[i].share]++] = i;
}

std::uint32_t ManifoldBuilder::ShareOf(const Page& page) const {
  const GridCell corner = m_.atlas_.CellOf({page.patch, 0});
  const auto column = static_cast<std::uint32_t>(corner.column / (2 * kTileSide)),
             row = static_cast<std::uint32_t>(corner.row / (2 * kTileSide));
  return (column % 2 + 2 * (row % 2)) * kShares + (column / 2 + 7 * (row / 2)) % kShares;
}

void ManifoldBuilder::Sweep(Turn& turn) {
  Page& page = m_.pages_[turn.page];
  const PatchAtlas::Shape& shape = m_.atlas_.shape(page.patch);
  LatticeDistance* values = &m_.values_[page.first_value];
  TileDistances tile;
  LoadTile(shape, values, tile);
  const bool diagonal = m_.atlas_.connectivity() == Connectivity::kEight;
  page.cells |= RelaxTile(shape.moves, shape.open, diagonal, tile) & shape.cells;
  for (std::size_t i = 0; i < tile.at.size(); ++i) tile.at[i] = tile.at[i] > m_.limit_ ? kUnreached : tile.at[i];
  StoreTile(shape, tile, values);
  turn.share = ShareOf(page);
  FollowLinks(turn);
}

/// Finds the pages that the page can now hand distances to, as far as there are any.
void ManifoldBuilder::FollowLinks(Turn& turn) {
  const Page& page = m_.pages_[turn.page];
  const auto links = m_.atlas_.links(page.patch);
  for (std::size_t i = 0; i < links.size(); ++i) {
    PageNumber& to = m_.links_[page.first_link + i];
    if (to != kNoPage || !CanCross(page, links[i])) continue;
    to = Find(PatchAtlas::LinkedTo(page.patch, links[i]), FindAcross(page.word, links[i].word));
    (to == kNoPage ? turn.open_links : turn.fresh_links) |= BitOf(i);
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

void ManifoldBuilder::MakeLinks(const Turn& turn) {
  if (turn.open_links == 0) return;
  const auto links = m_.atlas_.links(m_.pages_[turn.page].patch);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Page& page = m_.pages_[turn.page];
    if ((turn.open_links & BitOf(i)) == 0 || m_.links_[page.first_link + i] != kNoPage) continue;
    if (i >= 63 && !CanCross(page, links[i])) continue;
    const PageNumber to = Obtain(PatchAtlas::LinkedTo(page.patch, links[i]), WordAcross(page.word, links[i].word));
    m_.links_[page.first_link + i] = to;
    m_.links_[m_.pages_[to].first_link + links[i].back] = turn.page;
  }
}

WordTrie::WordNumber ManifoldBuilder::WordAcross(WordTrie::WordNumber word, WordTrie::WordNumber change) {
  if (change == WordTrie::kEmpty) return word;
  const WordTrie& words = m_.atlas_.words();
  return m_.words_.Append(WordAcross(word, words.parent(change)), words.last(change));
}

/// The same where it is known, or WordTrie::kMissing.
WordTrie::WordNumber ManifoldBuilder::FindAcross(WordTrie::WordNumber word, WordTrie::WordNumber change) const {
  if (change == WordTrie::kEmpty) return word;
  const WordTrie& words = m_.atlas_.words();
  const WordTrie::WordNumber before = FindAcross(word, words.parent(change));
  return before == WordTrie::kMissing ? before : m_.words_.Find(before, words.last(change));
}

/// Nothing is reached yet in the pages from `first` to before `last`.
void ManifoldBuilder::ClearPages(std::size_t first, std::size_t last) {
  for (std::size_t page = first; page < last; ++page) {
    LatticeDistance* values = &m_.values_[m_.pages_[page].first_value];
    std::fill(values, values + m_.atlas_.shape(m_.pages_[page].patch).count, kUnreached);
  }
}

/// Asks for the distances of a page.
void ManifoldBuilder::FetchValues(PageNumber number) const {
  const Page& page = m_.pages_[number];
  const std::size_t count = m_.atlas_.shape(page.patch).count;
  for (std::size_t at = 0; at < count; at += kLine) __builtin_prefetch(&m_.values_[page.first_value + at], 1);
}

void ManifoldBuilder::FetchPagesBeside(PageNumber number) const {
  const Page& page = m_.pages_[number];
  const std::size_t links = m_.atlas_.links(page.patch).size();
  for (std::size_t i = 0; i < links; ++i) {
    const PageNumber to = m_.links_[page.first_link + i];
    if (to != kNoPage) __builtin_prefetch(&m_.pages_[to], 1);
  }
}

/// Asks for the memory that handing on will write to, which lies all over.
void ManifoldBuilder::FetchBeside(PageNumber number) const {
  const Page& page = m_.pages_[number];
  const auto links = m_.atlas_.links(page.patch);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const PageNumber to = m_.links_[page.first_link + i];
    if (to == kNoPage) continue;
    const Page& other = m_.pages_[to];
    const PatchAtlas::Crossing& crossing = m_.atlas_.crossings(links[i])[0];
    const TileMask cells = Moved(crossing.from, crossing.offset);
    const PatchAtlas::Shape& shape = m_.atlas_.shape(other.patch);
    const std::size_t first = shape.position[static_cast<std::size_t>(__builtin_ctzll(cells))];
    const std::size_t last = shape.position[static_cast<std::size_t>(63 - __builtin_clzll(cells))];
    for (std::size_t at = first; at < last; at += kLine) __builtin_prefetch(&m_.values_[other.first_value + at], 1);
    __builtin_prefetch(&m_.values_[other.first_value + last], 1);
  }
}

/// Offers the changed distances of a page to the pages beside it, and lists those that are to wait for an earlier turn.
void ManifoldBuilder::HandOn(const Turn& turn, std::vector<Waiting>& waiting) {
  Page& page = m_.pages_[turn.page];
  const auto links = m_.atlas_.links(page.patch);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const PageNumber to = m_.links_[page.first_link + i];
    if (to == kNoPage) continue;
    Page& other = m_.pages_[to];
    if ((turn.fresh_links & BitOf(i)) != 0) m_.links_[other.first_link + links[i].back] = turn.page;
    const HandedOn handed = HandAcrossLink(page, links[i], other);
    if (handed.lowered == 0) continue;
    other.cells |= handed.lowered;
    other.key = std::min(other.key, handed.least);
    if (other.key / kBucket >= other.queued / kBucket) continue;
    other.queued = other.key;
    waiting.push_back({to, static_cast<std::uint32_t>(other.key / kBucket)});
  }
  // What other pages have offered to it meanwhile, it hands on when its turn comes.
  if (page.key == kUnreached) page.cells = 0;
}

HandedOn ManifoldBuilder::HandAcrossLink(const Page& page, const PatchAtlas::Link& link, const Page& other) {
  const LatticeDistance* values = &m_.values_[page.first_value];
  LatticeDistance* others = &m_.values_[other.first_value];
  if (link.open_side != PatchAtlas::kNotOpen) {
    return HandAcross(link.open_side, m_.atlas_.connectivity() == Connectivity::kEight, m_.limit_, values, others);
  }
  const PatchAtlas::Shape& shape = m_.atlas_.shape(page.patch);
  const PatchAtlas::Shape& other_shape = m_.atlas_.shape(other.patch);
  HandedOn handed;
  for (const PatchAtlas::Crossing& crossing : m_.atlas_.crossings(link)) {
    const LatticeDistance step = StepLength(crossing.direction);
    for (TileMask cells = page.cells & crossing.from; cells != 0; cells &= cells - 1) {
      const int cell = __builtin_ctzll(cells), beside = cell + crossing.offset;
      const LatticeDistance offer = values[shape.position[static_cast<std::size_t>(cell)]] + step;
      LatticeDistance& value = others[other_shape.position[static_cast<std::size_t>(beside)]];
      if (offer >= value || offer > m_.limit_) continue;
      value = offer;
      handed.lowered |= TileMask{1} << beside;
      handed.least = std::min(handed.least, offer);
    }
  }
  return handed;
}

void ManifoldBuilder::LetWait(const std::vector<Waiting>& waiting) {
  for (const Waiting& page : waiting) buckets_[page.bucket].push_back(page.page);
}

/// The pages of one word stand in the order of their patches, so that those beside each other in the ground are mostly
/// found in the same lines of memory; where another word's stand, they go on far away, still in order.
std::size_t ManifoldBuilder::Slot(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word) const {
  constexpr std::size_t kWordStride = 2'654'435'769, kJump = 40'503;
  const std::size_t mask = m_.page_table_.size() - 1;
  std::size_t slot = (patch + word * kWordStride) & mask;
  while (m_.page_table_[slot] != kNoPage) {
    const Page& page = m_.pages_[m_.page_table_[slot]];
    if (page.patch == patch && page.word == word) break;
    slot = (slot + kJump) & mask;
  }
  return slot;
}

ManifoldBuilder::PageNumber ManifoldBuilder::Find(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word) const {
  return word == WordTrie::kMissing ? kNoPage : m_.page_table_[Slot(patch, word)];
}

std::uint32_t ManifoldBuilder::Obtain(PatchAtlas::PatchNumber patch, WordTrie::WordNumber word) {
  const std::size_t slot = Slot(patch, word);
  if (m_.page_table_[slot] != kNoPage) return m_.page_table_[slot];
  const std::size_t links = m_.atlas_.links(patch).size();
  const std::size_t first_value = m_.values_.Grow(m_.atlas_.shape(patch).count);
  const std::size_t first_link = m_.links_.Grow(links);
  TAUTLINE_CHECK(first_value < kNoPage && first_link < kNoPage);
  std::fill_n(&m_.links_[first_link], links, kNoPage);
  const auto number = static_cast<std::uint32_t>(m_.pages_.Grow(1));
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
      Page& here = m_.pages_[page];
      here.cells = ReachedCells(m_.atlas_.shape(here.patch), &m_.values_[here.first_value]);
      FindLinks(static_cast<std::uint32_t>(page));
    }
  });
  std::vector<PageNumber>().swap(m_.page_table_);
  if (m_.stop_ != ManifoldStop::kNone || m_.length_m_ <= kFarthestCells * m_.ground_.cell_m()) return;
  for (std::uint32_t page = 0; page < m_.page_count_; ++page) {
    const LatticeDistance* values = &m_.values_[m_.pages_[page].first_value];
    for (int i = 0; i < m_.atlas_.shape(m_.pages_[page].patch).count; ++i) {
      if (values[i] != kUnreached && values[i] > m_.limit_ - kDiagonalStep) m_.stop_ = ManifoldStop::kDistance;
    }
  }
}

/// Where no vertex of the page can step across a link, it does not matter where that leads.
void ManifoldBuilder::FindLinks(PageNumber number) {
  const Page& page = m_.pages_[number];
  const auto links = m_.atlas_.links(page.patch);
  for (std::size_t i = 0; i < links.size(); ++i) {
    PageNumber& to = m_.links_[page.first_link + i];
    if (to != kNoPage) continue;
    const auto crossings = m_.atlas_.crossings(links[i]);
    const bool leads_on = std::any_of(crossings.begin(), crossings.end(), [&](const PatchAtlas::Crossing& crossing) {
      return (crossing.from & page.cells) != 0;
    });
    if (leads_on) to = Find(PatchAtlas::LinkedTo(page.patch, links[i]), FindAcross(page.word, links[i].word));
  }
}

}  // namespace tautline
