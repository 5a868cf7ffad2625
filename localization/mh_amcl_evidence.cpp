// What MH-AMCL believes: the evidence of each place, and which one is the output.
#include <algorithm>

#include "localization/hypotheses/select.hpp"
#include "localization/mh_amcl.hpp"

namespace castaway::localization {

/// Adds the scan to the evidence of every place and remembers it.
void MhAmcl::weigh(const ScanPoints& points, const SE2& T_odom_base) {
  double e = 1.0;
  double cue = 0.0;
  if (!history_.empty()) {
    const ScanMemory& before = history_.back();
    e = independence(config_.posterior, distance(before.T_odom_base, T_odom_base),
                     yaw_distance(before.T_odom_base, T_odom_base));
    cue = kidnap_cue(config_.posterior,
                     scan_agreement(config_.agreement, before.points, points,
                                    before.T_odom_base.inverse() * T_odom_base),
                     e);
  }
  kidnap_hint_ = std::max(cue, kidnap_hint_ - e);
  const double listed = listed_log_weight(hypotheses_);
  history_.push_back({points, T_odom_base, e, listed, unlisted_.log_weight, cue});
  if (history_.size() > static_cast<std::size_t>(config_.history)) history_.pop_front();
  if (paper_) return;  // the paper weighs populations by the quality of the newest scan alone
  for (Hypothesis& hypothesis : hypotheses_) {
    const Evidence evidence = evidence_.evaluate(points, hypothesis.belief.mean);
    hypothesis.log_weight += evidence.log_likelihood - (1.0 - e) * hypothesis.log_likelihood;
    hypothesis.log_likelihood = evidence.log_likelihood;
    hypothesis.quality = evidence.quality;
  }
  advance_unlisted(config_.posterior, e, listed, cue, unlisted_);
  if (const Hypothesis* output = selected()) {
    doubt_output(config_.posterior, output->log_likelihood, listed_log_weight(hypotheses_),
                 unlisted_);
  }
}

/// Selects the output and learns what is usual while it is confident. Having been lost it takes
/// more to be found than to stay so: where a map has look-alikes or is out of date, scan after scan
/// errs the same way, and the first few are believed too readily.
void MhAmcl::choose() {
  if (paper_) return choose_by_quality();
  const auto output = select(hypotheses_, selected_id_, config_.select_margin);
  if (!output) return;
  const Hypothesis& hypothesis = hypotheses_[*output];
  const bool was_confident = probability_ >= config_.match.confident;
  const bool same = selected_id_ == hypothesis.id;
  selected_id_ = hypothesis.id;
  probability_ = shares(hypotheses_, unlisted_)[*output];
  const bool confident = probability_ >= config_.match.confident;
  if (confident && !history_.empty()) {
    learn_usual(config_.posterior, hypothesis.log_likelihood, history_.back().independence,
                unlisted_);
  }
  if (!same) note_jump();
  found_ = confident && proven() && ((found_ && same) || probability_ >= config_.found);
  was_found_ = was_found_ || found_;
  if (was_confident && !confident) {
    pause_s_ = 0.0;
    searches_ = 0;
  }
}

/// A robot that knew where it is and was not carried off is where it was: an output that is
/// somewhere else now was misled by the map, before or now, and must prove itself.
void MhAmcl::note_jump() {
  jumped_at_.reset();
  const bool explained = kidnap_hint_ >= config_.unexplained_cue;
  if (was_found_ && !explained && !history_.empty()) jumped_at_ = history_.back().T_odom_base;
}

bool MhAmcl::proven() const {
  return !jumped_at_ || distance(*jumped_at_, history_.back().T_odom_base) >= config_.proving_m;
}

Hypothesis* MhAmcl::selected() {
  const auto found = std::find_if(hypotheses_.begin(), hypotheses_.end(),
                                  [&](const Hypothesis& h) { return h.id == selected_id_; });
  return found == hypotheses_.end() ? nullptr : &*found;
}

}  // namespace castaway::localization
