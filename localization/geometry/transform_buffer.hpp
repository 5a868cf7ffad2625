/// The recent past of a moving frame, asked at any time.
#pragma once

#include <deque>
#include <optional>

#include "localization/geometry/se2.hpp"
#include "localization/geometry/stamp.hpp"

namespace castaway::localization {

/// Sizes of a buffer.
struct TransformBufferConfig {
  Stamp length = std::chrono::seconds(10);      ///< Older transforms are forgotten.
  Stamp hold = std::chrono::milliseconds(500);  ///< Beyond the newest one, it is held this long.
};

/// Keeps `T_parent_child` over time (odom -> base) and interpolates between the stamps.
class TransformBuffer {
 public:
  explicit TransformBuffer(const TransformBufferConfig& config = {}) : config_(config) {}

  /// Adds a transform. False, and nothing changes, unless `stamp` is newer than the newest.
  bool add(Stamp stamp, const SE2& T_parent_child);
  /// `T_parent_child` at `stamp`: interpolated, held after the newest; nothing outside of what is
  /// known.
  [[nodiscard]] std::optional<SE2> at(Stamp stamp) const;
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  /// Stamp of the newest transform. Not to be asked of an empty buffer.
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
