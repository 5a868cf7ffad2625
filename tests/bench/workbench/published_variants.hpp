/// MH-AMCL's mode `paper` with each defect of the published code alone, and with all of them.
#pragma once

#include <string>
#include <vector>

#include "localization/paper/published/published_config.hpp"
#include "tools/run/metrics/localizer_metrics.hpp"

namespace castaway::testbed {

/// A localizer configuration to compare.
struct PublishedVariant {
  std::string name;
  localization::PublishedMhAmclConfig config;
};

/// Returns `paper`; `+ <defect>` for each defect; `+ its figures` (the published code's parameters
/// without its defects); and `published`.
std::vector<PublishedVariant> published_variants();

/// Results of several runs of one variant.
struct VariantScore {
  std::string name;
  int events = 0;  ///< Kidnaps and unknown starts.
  int recovered = 0;
  std::vector<double> time_s;      ///< [s] Times of all recoveries.
  std::vector<double> tracking_m;  ///< [m] Mean tracking error of every run that has one.
  std::vector<double> wrong;       ///< Wrong-lock share of every run that has one.

  void add(const LocalizerMetrics& metrics);
};

}  // namespace castaway::testbed
