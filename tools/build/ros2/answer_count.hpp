/// Which scans a node answered.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "castaway/stamp.hpp"

namespace castaway::testbed {

/// Matches answers to scans by their stamps, and counts.
class AnswerCount {
 public:
  /// A scan was sent; its answer has this stamp or a later one. The scan before is not waited for
  /// any longer.
  void expect(localization::Stamp scan);
  /// The newest scan was sent again: it may be answered again.
  void repeat() { ++repeats_; }
  /// An answer came.
  void take(localization::Stamp stamp);
  /// True if the newest scan was answered since it was sent.
  [[nodiscard]] bool answered() const { return answered_; }
  /// No answer to the newest scan is waited for any longer.
  void give_up();

  /// Scans "sent", "answered" in time and "missing"; answers "late", to a scan before the newest,
  /// and "doubled", with the stamp of the answer before.
  [[nodiscard]] std::map<std::string, std::int64_t> counts() const;

 private:
  [[nodiscard]] bool is_open() const;

  std::optional<localization::Stamp> scan_;
  std::optional<localization::Stamp> newest_;  ///< Of all answers.
  std::int64_t repeats_ = 0;                   ///< Of the newest scan, not answered again.
  bool answered_ = false;
  bool given_up_ = false;
  std::int64_t sent_ = 0;
  std::int64_t in_time_ = 0;
  std::int64_t missing_ = 0;
  std::int64_t late_ = 0;
  std::int64_t doubled_ = 0;
};

}  // namespace castaway::testbed
