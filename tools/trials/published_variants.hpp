/// MH-AMCL's mode `paper` with each defect of the published code alone, and with all of them.
#pragma once

#include <string>
#include <vector>

#include "localization/paper/published/published_config.hpp"
#include "tools/metrics/localizer_metrics.hpp"

namespace castaway::testbed {

/// A localizer of the comparison.
struct PublishedVariant {
  std::string name;
  localization::PublishedMhAmclConfig config;
};

/// `paper`; `+ <defect>` for each; `+ its figures` (the published code's parameters, no defect);
/// `published`.
std::vector<PublishedVariant> published_variants();

/// What several runs of one variant amount to.
struct VariantScore {
  std::string name;
  int events = 0;  ///< Kidnaps and unknown starts.
  int recovered = 0;
  std::vector<double> time_s;      ///< [s] Of every recovery.
  std::vector<double> tracking_m;  ///< [m] Mean tracking error of every run that has one.
  std::vector<double> wrong;       ///< Wrong-lock share of every run that has one.

  void add(const LocalizerMetrics& metrics);
};

}  // namespace castaway::testbed
