#include "tools/twin/prediction/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <boost/random/uniform_int_distribution.hpp>

#include "localization/geometry/random.hpp"
#include "tools/run/metrics/statistics/rank_correlation.hpp"

namespace castaway::testbed {
namespace {

constexpr double kNear = 0.25;  // Relative.

/// Rows by log, and within a log by localizer, both in the order in which they first appear.
using RowsByLog = std::vector<std::vector<const PredictionRow*>>;

RowsByLog group(const std::vector<PredictionRow>& rows) {
  RowsByLog logs;
  std::map<std::string, std::size_t> index;
  for (const PredictionRow& row : rows) {
    const auto [found, added] = index.try_emplace(row.log.log, logs.size());
    if (added) logs.emplace_back();
    logs[found->second].push_back(&row);
  }
  return logs;
}

/// Mean success of each localizer.
struct Successes {
  std::vector<double> measured;
  std::vector<double> predicted;
};

/// Successes of a bootstrap sample. A trial that is drawn counts for every localizer.
Successes sample_successes(const RowsByLog& logs, localization::Rng& rng) {
  using IndexDraw = boost::random::uniform_int_distribution<std::size_t>;
  const std::size_t localizers = logs.front().size();
  Successes mean{std::vector<double>(localizers), std::vector<double>(localizers)};
  for (std::size_t k = 0; k < logs.size(); ++k) {
    const auto& rows = logs[IndexDraw(0, logs.size() - 1)(rng)];
    const std::size_t trials = rows.front()->trials.size();
    const double weight = 1.0 / static_cast<double>(trials * logs.size());
    for (std::size_t i = 0; i < trials; ++i) {
      const std::size_t drawn = IndexDraw(0, trials - 1)(rng);
      for (std::size_t l = 0; l < localizers; ++l) {
        const PredictedTrial& trial = rows[l]->trials[drawn];
        mean.measured[l] += trial.recovered ? weight : 0.0;
        mean.predicted[l] += weight * trial.predicted;
      }
    }
  }
  return mean;
}

void add_tracking(const PredictionRow& row, LocalizerAgreement& sum) {
  const auto& measured = row.log.tracking_no_alarm_m;
  const auto& predicted = row.twin.tracking_no_alarm_m;
  if (!measured || !predicted) return;
  ++sum.tracked;
  if (std::abs(*predicted - *measured) <= kNear * *measured) ++sum.tracked_near;
}

}  // namespace

std::vector<LocalizerAgreement> by_localizer(const std::vector<PredictionRow>& rows) {
  std::vector<LocalizerAgreement> all;
  const RowsByLog logs = group(rows);
  if (logs.empty()) return all;
  const double weight = 1.0 / static_cast<double>(logs.size());
  for (std::size_t l = 0; l < logs.front().size(); ++l) {
    LocalizerAgreement sum;
    sum.localizer = logs.front()[l]->log.localizer;
    for (const auto& log : logs) {
      const double measured = success_of(log[l]->log);
      const double predicted = success_of(log[l]->twin);
      sum.measured += weight * measured;
      sum.predicted += weight * predicted;
      sum.apart += weight * std::abs(predicted - measured);
      add_tracking(*log[l], sum);
    }
    all.push_back(sum);
  }
  return all;
}

std::optional<BootstrapFigure> rank_agreement(const std::vector<PredictionRow>& rows) {
  constexpr int kResamples = 1000;
  Successes all;
  for (const LocalizerAgreement& localizer : by_localizer(rows)) {
    all.measured.push_back(localizer.measured);
    all.predicted.push_back(localizer.predicted);
  }
  const auto tau = kendall_tau(all.measured, all.predicted);
  if (!tau) return std::nullopt;
  const RowsByLog logs = group(rows);
  if (logs.size() < 2) return BootstrapFigure{*tau};
  localization::Rng rng = localization::substream(1, "rank_agreement");
  std::vector<double> drawn;
  for (int k = 0; k < kResamples; ++k) {
    const Successes sampled = sample_successes(logs, rng);
    if (const auto t = kendall_tau(sampled.measured, sampled.predicted)) drawn.push_back(*t);
  }
  std::sort(drawn.begin(), drawn.end());
  if (drawn.empty()) return std::nullopt;
  return BootstrapFigure{*tau, Interval{percentile(drawn, 0.025), percentile(drawn, 0.975)}};
}

}  // namespace castaway::testbed
