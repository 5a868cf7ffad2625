/// Progress lines, on a terminal only.
#pragma once

#include <chrono>
#include <string>

#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Shows the time reached, the duration and the real-time factor on a terminal; nothing in a pipe.
/// Throws Interrupted at the next scan after a signal.
class ProgressSink final : public RunSink {
 public:
  /// `quiet`: shows nothing on a terminal either.
  ProgressSink(Stamp duration, bool quiet);
  /// Removes the line.
  ~ProgressSink() override;
  ProgressSink(const ProgressSink&) = delete;
  ProgressSink& operator=(const ProgressSink&) = delete;

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp, const RunTiming&) override {}

 private:
  void show(Stamp reached);

  Stamp duration_;
  bool terminal_;
  std::chrono::nanoseconds begin_;
  std::chrono::nanoseconds shown_{};
};

/// Shows runs done and in all, the rate, the time left and the result so far on a terminal; nothing
/// in a pipe.
class CampaignProgress {
 public:
  /// `what`: the plural of what is counted.
  CampaignProgress(int all, std::string what);
  /// Removes the line.
  ~CampaignProgress();
  CampaignProgress(const CampaignProgress&) = delete;
  CampaignProgress& operator=(const CampaignProgress&) = delete;

  /// One more is done; `result`: of all so far, in a few words.
  void next(const std::string& result);

 private:
  int done_ = 0;
  int all_;
  std::string what_;
  bool terminal_;
  std::chrono::nanoseconds begin_;
};

/// Shows trials done and in all on a terminal; nothing in a pipe.
class TrialCount {
 public:
  explicit TrialCount(int all);
  void next();

 private:
  int done_ = 0;
  int all_;
  bool terminal_;
};

}  // namespace castaway::testbed
