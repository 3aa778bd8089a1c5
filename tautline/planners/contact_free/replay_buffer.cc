#include "tautline/planners/contact_free/replay_buffer.h"

#include <algorithm>

#include "tautline/base/check.h"

namespace tautline {

ReplayBuffer::ReplayBuffer(std::size_t capacity, std::size_t inputs)
    : capacity_(capacity),
      inputs_(inputs),
      before_(capacity * inputs),
      after_(capacity * inputs),
      rewards_(capacity),
      goes_on_(capacity),
      actions_(capacity) {
  TAUTLINE_CHECK(capacity > 0 && inputs > 0);
}

void ReplayBuffer::Add(const Transition& transition) {
  TAUTLINE_CHECK(transition.before.size() == inputs_ && transition.after.size() == inputs_);
  TAUTLINE_CHECK(transition.action >= 0 && transition.action < 256);
  const auto row = static_cast<std::ptrdiff_t>(next_ * inputs_);
  std::copy(transition.before.begin(), transition.before.end(), before_.begin() + row);
  std::copy(transition.after.begin(), transition.after.end(), after_.begin() + row);
  actions_[next_] = static_cast<std::uint8_t>(transition.action);
  rewards_[next_] = static_cast<float>(transition.reward);
  goes_on_[next_] = transition.terminal ? 0 : 1;
  next_ = (next_ + 1) % capacity_;
  size_ = std::min(size_ + 1, capacity_);
}

void ReplayBuffer::Sample(int count, Rng& rng, TransitionBatch& batch) const {
  TAUTLINE_CHECK(size_ > 0);
  batch.before.clear();
  batch.actions.clear();
  batch.rewards.clear();
  batch.after.clear();
  batch.goes_on.clear();
  for (int i = 0; i < count; ++i) {
    const auto chosen = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(size_) - 1));
    const auto row = static_cast<std::ptrdiff_t>(chosen * inputs_), end = row + static_cast<std::ptrdiff_t>(inputs_);
    batch.before.insert(batch.before.end(), before_.begin() + row, before_.begin() + end);
    batch.after.insert(batch.after.end(), after_.begin() + row, after_.begin() + end);
    batch.actions.push_back(actions_[chosen]);
    batch.rewards.push_back(rewards_[chosen]);
    batch.goes_on.push_back(goes_on_[chosen]);
  }
}

void ReplayBuffer::Save(StateWriter& writer) const {
  writer.Whole(static_cast<std::int64_t>(size_));
  writer.Whole(static_cast<std::int64_t>(next_));
  for (const auto* values : {&before_, &after_, &rewards_, &goes_on_}) writer.Floats(*values);
  writer.Text({reinterpret_cast<const char*>(actions_.data()), actions_.size()});
}

bool ReplayBuffer::Load(StateReader& reader, int actions) {
  const std::int64_t size = reader.Whole(), next = reader.Whole();
  const auto limit = static_cast<std::int64_t>(capacity_);
  if (size < 0 || size > limit || next < 0 || next >= limit) return false;
  size_ = static_cast<std::size_t>(size);
  next_ = static_cast<std::size_t>(next);
  for (auto* values : {&before_, &after_, &rewards_, &goes_on_}) {
    auto read = reader.Floats();
    if (read.size() != values->size()) return false;
    *values = std::move(read);
  }
  const std::string_view done = reader.Text();
  if (done.size() != actions_.size()) return false;
  std::copy(done.begin(), done.end(), actions_.begin());
  return reader.whole() && std::all_of(actions_.begin(), actions_.end(), [&](int action) { return action < actions; });
}

}  // namespace tautline
