/// Progress lines, on a terminal only.
#pragma once

#include <chrono>
#include <string>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Shows time reached, time in all and the real-time factor on a terminal; nothing in a pipe.
class Progress {
 public:
  /// `quiet`: shows nothing on a terminal either.
  explicit Progress(Stamp duration, bool quiet = false);
  /// Removes the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(Stamp reached);

 private:
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
