/// The scans of a live run so far, for pages that open later.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Keeps what frames (`LiveFeed::take_frame`) told of scans, without their beams and particles. The
/// oldest ones are given up.
class LiveHistory {
 public:
  /// `most`: scans that are kept.
  explicit LiveHistory(std::size_t most = 18000) : most_(most) {}
  /// Adds the scans of a frame; those of a run that went back replace what came later.
  void add(std::string_view frame);
  /// Leaves out what is later than a time [s].
  void cut(double time_s);
  /// {"said": "history", "scans": [...]}, as in frames; empty if there is none.
  [[nodiscard]] std::string message() const;
  [[nodiscard]] std::size_t scans() const { return scans_.size(); }

 private:
  struct Scan {
    double time_s;
    std::string row;  ///< JSON.
  };

  std::size_t most_;
  std::deque<Scan> scans_;
};

}  // namespace castaway::testbed
