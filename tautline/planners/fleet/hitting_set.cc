#include "tautline/planners/fleet/hitting_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tautline/geometry/disjoint_sets.h"

namespace tautline {
namespace {

/// How many, and how dear.
using Price = std::pair<std::size_t, double>;

/// One connected part of the sets; its items are numbered from 0.
class PartSearch {
 public:
  PartSearch(std::vector<ItemSet> sets, std::vector<double> costs, std::size_t& nodes)
      : sets_(std::move(sets)),
        costs_(std::move(costs)),
        nodes_(nodes),
        chosen_(costs_.size(), false),
        banned_(costs_.size(), false) {
    std::sort(sets_.begin(), sets_.end(),
              [](const ItemSet& a, const ItemSet& b) { return a.size() != b.size() ? a.size() < b.size() : a < b; });
    for (const ItemSet& set : sets_) {
      for (const std::int32_t item : set) sets_of_[item].push_back(&set);
    }
  }

  HittingSet Run() {
    bound_ = Packing().first;
    BeGreedy();
    Branch({0, 0});
    HittingSet result{.chosen = best_, .optimal = !out_of_nodes_};
    result.bound = out_of_nodes_ ? bound_ : best_.size();
    return result;
  }

 private:
  bool IsHit(const ItemSet& set) const {
    return std::any_of(set.begin(), set.end(), [&](std::int32_t item) { return Is(chosen_, item); });
  }

  static bool Is(const std::vector<bool>& flags, std::int32_t item) { return flags[static_cast<std::size_t>(item)]; }

  /// A lower bound of what the sets that are not hit still cost: disjoint ones, shortest first.
  Price Packing() const {
    std::vector<bool> used(costs_.size(), false);
    Price price{0, 0};
    for (const ItemSet& set : sets_) {
      const auto is_used = [&](std::int32_t item) { return Is(used, item); };
      if (IsHit(set) || std::any_of(set.begin(), set.end(), is_used)) continue;
      double least = HUGE_VAL;
      for (const std::int32_t item : set) {
        if (Is(banned_, item)) continue;
        used[static_cast<std::size_t>(item)] = true;
        least = std::min(least, costs_[static_cast<std::size_t>(item)]);
      }
      ++price.first;
      price.second += least;
    }
    return price;
  }

  void BeGreedy() {
    Price price{0, 0};
    for (;;) {
      std::vector<std::size_t> hits(costs_.size(), 0);
      for (const ItemSet& set : sets_) {
        if (IsHit(set)) continue;
        for (const std::int32_t item : set) ++hits[static_cast<std::size_t>(item)];
      }
      std::size_t pick = 0;
      for (std::size_t i = 1; i < hits.size(); ++i) {
        if (hits[i] > hits[pick] || (hits[i] == hits[pick] && costs_[i] < costs_[pick])) pick = i;
      }
      if (hits[pick] == 0) break;
      chosen_[pick] = true;
    }
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      if (!chosen_[i]) continue;
      chosen_[i] = false;
      const auto& sets = sets_of_[static_cast<std::int32_t>(i)];
      if (std::all_of(sets.begin(), sets.end(), [&](const ItemSet* set) { return IsHit(*set); })) continue;
      chosen_[i] = true;
      price.first += 1;
      price.second += costs_[i];
    }
    Keep(price);
    chosen_.assign(costs_.size(), false);
  }

  void Keep(Price price) {
    best_price_ = price;
    best_.clear();
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      if (chosen_[i]) best_.push_back(static_cast<std::int32_t>(i));
    }
  }

  void Branch(Price price) {
    if (nodes_ == 0) {
      out_of_nodes_ = true;
      return;
    }
    --nodes_;
    const Price rest = Packing();
    if (Price{price.first + rest.first, price.second + rest.second} >= best_price_) return;
    const ItemSet* next = Next();
    if (next == nullptr) return Keep(price);
    ItemSet items = *next;
    items.erase(std::remove_if(items.begin(), items.end(), [&](std::int32_t i) { return Is(banned_, i); }),
                items.end());
    const auto reach = [&](std::int32_t item) { return sets_of_[item].size(); };
    std::stable_sort(items.begin(), items.end(), [&](auto p, auto q) { return reach(p) > reach(q); });
    // Each item in turn, those before it banned, so that no choice is looked at twice.
    for (const std::int32_t item : items) {
      const auto i = static_cast<std::size_t>(item);
      chosen_[i] = true;
      Branch({price.first + 1, price.second + costs_[i]});
      chosen_[i] = false;
      banned_[i] = true;
    }
    for (const std::int32_t item : items) banned_[static_cast<std::size_t>(item)] = false;
  }

  /// The set that is not hit with the fewest items that may still be chosen.
  const ItemSet* Next() const {
    const ItemSet* next = nullptr;
    std::ptrdiff_t least = 0;
    for (const ItemSet& set : sets_) {
      if (IsHit(set)) continue;
      const auto count = std::count_if(set.begin(), set.end(), [&](std::int32_t i) { return !Is(banned_, i); });
      if (next != nullptr && count >= least) continue;
      next = &set;
      least = count;
    }
    return next;
  }

  std::vector<ItemSet> sets_;
  std::vector<double> costs_;
  std::size_t& nodes_;
  std::map<std::int32_t, std::vector<const ItemSet*>> sets_of_;
  std::vector<bool> chosen_, banned_;
  ItemSet best_;
  Price best_price_{0, 0};
  std::size_t bound_ = 0;
  bool out_of_nodes_ = false;
};

}  // namespace

HittingSet LeastHittingSet(const std::vector<ItemSet>& sets, const std::vector<double>& costs, std::size_t& nodes) {
  DisjointSets parts(costs.size());
  for (const ItemSet& set : sets) {
    for (const std::int32_t item : set) {
      parts.Unite(static_cast<std::size_t>(set[0]), static_cast<std::size_t>(item));
    }
  }
  std::map<std::size_t, std::vector<const ItemSet*>> sets_of;
  for (const ItemSet& set : sets) sets_of[parts.Find(static_cast<std::size_t>(set[0]))].push_back(&set);
  HittingSet result;
  for (const auto& [root, part] : sets_of) {
    std::map<std::int32_t, std::int32_t> number;
    for (const ItemSet* set : part) {
      for (const std::int32_t item : *set) number[item];
    }
    std::vector<double> part_costs;
    ItemSet items;
    for (auto& [item, position] : number) {
      position = static_cast<std::int32_t>(items.size());
      items.push_back(item);
      part_costs.push_back(costs[static_cast<std::size_t>(item)]);
    }
    std::vector<ItemSet> numbered;
    for (const ItemSet* set : part) {
      ItemSet& copy = numbered.emplace_back();
      for (const std::int32_t item : *set) copy.push_back(number[item]);
    }
    const HittingSet least = PartSearch(std::move(numbered), std::move(part_costs), nodes).Run();
    for (const std::int32_t item : least.chosen) result.chosen.push_back(items[static_cast<std::size_t>(item)]);
    result.optimal = result.optimal && least.optimal;
    result.bound += least.bound;
  }
  std::sort(result.chosen.begin(), result.chosen.end());
  return result;
}

}  // namespace tautline
