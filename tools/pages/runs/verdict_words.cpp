#include "tools/pages/runs/verdict_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/outputs/records/summary_kidnaps.hpp"
#include "tools/run/metrics/statistics/paired_shares.hpp"
#include "tools/run/metrics/statistics/sign_flip.hpp"

namespace castaway::testbed {
namespace {

/// Two localizers over the same kidnaps.
struct RecoveryPair {
  std::string first;
  std::string second;
  PairedOutcomes outcomes{};
};

bool is_same_kidnap(const SummaryKidnap& a, const SummaryKidnap& b) {
  constexpr double kSameTime = 1e-3;  // [s]
  return a.cause == b.cause && std::abs(a.at_s - b.at_s) < kSameTime;
}

void add_set_run(const SetRun& run, RecoveryPair& pair) {
  const std::vector<SummaryKidnap> first = summary_kidnaps(run.summary, pair.first);
  const std::vector<SummaryKidnap> second = summary_kidnaps(run.summary, pair.second);
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    if (!first[i].scored || !second[i].scored || !is_same_kidnap(first[i], second[i])) continue;
    pair.outcomes.add(first[i].recovered, second[i].recovered);
  }
}

std::vector<RecoveryPair> recovery_pairs(const RunSet& set) {
  std::vector<RecoveryPair> pairs;
  for (std::size_t i = 0; i < set.localizers.size(); ++i) {
    for (std::size_t k = i + 1; k < set.localizers.size(); ++k) {
      RecoveryPair pair{set.localizers[i], set.localizers[k]};
      for (const SetRun& run : set.runs) {
        if (!run.is_void) add_set_run(run, pair);
      }
      if (pair.outcomes.trials() > 0) pairs.push_back(std::move(pair));
    }
  }
  return pairs;
}

/// The number of kidnaps that it takes to tell any of so many pairs apart, if one localizer
/// recovers from all of them and the other from none.
int kidnaps_needed(std::size_t pairs) {
  int needed = 1;
  double p = static_cast<double>(pairs);  // Of one kidnap: 2 * 0.5, corrected by Holm.
  for (; p >= kSignificance; p *= 0.5) ++needed;
  return needed;
}

/// Of the first of two localizers if `sign` is 1, of the second one if it is -1.
std::string verdict_text(const RecoveryPair& pair, double p, int sign, int needed) {
  const std::string& other = sign > 0 ? pair.second : pair.first;
  if (pair.outcomes.trials() < needed) {
    return fmt::format("too few kidnaps to tell it from {}: {}, it takes {}", other,
                       pair.outcomes.trials(), needed);
  }
  if (p >= kSignificance) return fmt::format("no difference to {} seen ({})", other, p_text(p));
  const bool more = sign * pair.outcomes.difference() > 0.0;
  return fmt::format("recovers {} often than {} ({})", more ? "more" : "less", other, p_text(p));
}

}  // namespace

std::string p_text(double p) {
  return p < 0.001 ? std::string("p < 0.001") : fmt::format("p = {:.3f}", p);
}

std::map<std::string, std::string> recovery_verdicts(const RunSet& set) {
  const std::vector<RecoveryPair> pairs = recovery_pairs(set);
  std::vector<double> p_values;
  for (const RecoveryPair& pair : pairs) p_values.push_back(mcnemar_p_value(pair.outcomes));
  const std::vector<double> corrected = holm(p_values);
  std::map<std::string, std::string> verdicts;
  const auto add = [&](const std::string& localizer, const std::string& words) {
    std::string& text = verdicts[localizer];
    text += (text.empty() ? "" : "; ") + words;
  };
  const int needed = kidnaps_needed(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    add(pairs[i].first, verdict_text(pairs[i], corrected[i], 1, needed));
    add(pairs[i].second, verdict_text(pairs[i], corrected[i], -1, needed));
  }
  return verdicts;
}

}  // namespace castaway::testbed
