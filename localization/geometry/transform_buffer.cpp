#include "localization/geometry/transform_buffer.hpp"

#include <algorithm>
#include <cassert>

namespace castaway::localization {

bool TransformBuffer::add(Stamp stamp, const SE2& T_parent_child) {
  if (!entries_.empty() && stamp <= entries_.back().stamp) return false;
  entries_.push_back({stamp, T_parent_child});
  while (entries_.size() > 2 && entries_[1].stamp + config_.length < stamp) entries_.pop_front();
  return true;
}

std::optional<SE2> TransformBuffer::at(Stamp stamp) const {
  if (entries_.empty() || stamp < entries_.front().stamp) return std::nullopt;
  if (stamp > entries_.back().stamp + config_.hold) return std::nullopt;
  const auto after =
      std::upper_bound(entries_.begin(), entries_.end(), stamp,
                       [](Stamp value, const Entry& entry) { return value < entry.stamp; });
  const Entry& before = *std::prev(after);
  if (after == entries_.end()) return before.T_parent_child;
  const double fraction = seconds(stamp - before.stamp) / seconds(after->stamp - before.stamp);
  return interpolate(before.T_parent_child, after->T_parent_child, fraction);
}

Stamp TransformBuffer::newest() const {
  assert(!empty());
  return entries_.back().stamp;
}

}  // namespace castaway::localization
