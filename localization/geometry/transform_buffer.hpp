/// A buffer of a moving frame's recent transforms.
#pragma once

#include <deque>
#include <optional>

#include "castaway/stamp.hpp"
#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Sizes of a buffer.
struct TransformBufferConfig {
  Stamp length = std::chrono::seconds(10);  ///< Older transforms are dropped.
  /// The newest transform is valid for this long after its stamp.
  Stamp hold = std::chrono::milliseconds(500);
};

/// Keeps `T_parent_child` over time (odom -> base) and interpolates between the stamps.
class TransformBuffer {
 public:
  explicit TransformBuffer(const TransformBufferConfig& config = {}) : config_(config) {}

  /// Adds a transform. Returns false and changes nothing unless `stamp` is newer than the newest
  /// one.
  bool add(Stamp stamp, const SE2& T_parent_child);
  /// `T_parent_child` at `stamp`: interpolated, or the newest one held; nothing outside of the
  /// known times.
  [[nodiscard]] std::optional<SE2> at(Stamp stamp) const;
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// Stamp of the newest transform. Requires a buffer that is not empty.
  [[nodiscard]] Stamp newest() const;
  void clear() { entries_.clear(); }

 private:
  struct Entry {
    Stamp stamp{};
    SE2 T_parent_child;
  };
  TransformBufferConfig config_;
  std::deque<Entry> entries_;
};

}  // namespace castaway::localization
