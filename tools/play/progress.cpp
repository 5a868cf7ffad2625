#include "tools/play/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/output/progress_line.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/base/process/progress_text.hpp"

namespace castaway::testbed {

ProgressSink::ProgressSink(Stamp duration, bool quiet)
    : duration_(duration), terminal_(!quiet && isatty(fileno(stderr)) != 0), begin_(wall_time()) {}

ProgressSink::~ProgressSink() {
  if (terminal_) show_progress("");
}

void ProgressSink::on_scan(const ScanRecord& record) {
  throw_if_interrupted();
  show(record.delivered);
}

void ProgressSink::show(Stamp reached) {
  constexpr std::chrono::milliseconds kPause(100);
  const std::chrono::nanoseconds now = wall_time();
  if (!terminal_ || now - shown_ < kPause) return;
  shown_ = now;
  const double factor = localization::seconds(reached) / localization::seconds(now - begin_);
  const double left = localization::seconds(duration_ - reached) / std::max(factor, 1e-3);
  show_progress(fmt::format("{:7.1f} / {:.1f} s   {:.3g} x real time   {} left",
                            localization::seconds(reached), localization::seconds(duration_),
                            factor, minutes_and_seconds(left)));
}

CampaignProgress::CampaignProgress(int all, std::string what)
    : all_(all),
      what_(std::move(what)),
      terminal_(isatty(fileno(stderr)) != 0),
      begin_(wall_time()) {}

CampaignProgress::~CampaignProgress() {
  if (terminal_) show_progress("");
}

void CampaignProgress::next(const std::string& result) {
  ++done_;
  if (!terminal_) return;
  const double elapsed_s = localization::seconds(wall_time() - begin_);
  show_progress(progress_text(done_, all_, what_, elapsed_s) + (result.empty() ? "" : "; ") +
                result);
}

TrialCount::TrialCount(int all) : all_(all), terminal_(isatty(fileno(stderr)) != 0) {}

void TrialCount::next() {
  ++done_;
  if (!terminal_) return;
  show_progress(done_ == all_ ? "" : fmt::format("{} / {} trials", done_, all_));
}

}  // namespace castaway::testbed
