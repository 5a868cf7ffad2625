#include "tests/bench/workbench/published_variants.hpp"

#include "castaway/stamp.hpp"

namespace castaway::testbed {

std::vector<PublishedVariant> published_variants() {
  using localization::NamedDefect;
  const localization::PublishedMhAmclConfig paper{};
  std::vector<PublishedVariant> variants = {{"paper", paper}};
  for (const NamedDefect& defect : localization::named_defects()) {
    PublishedVariant variant{"+ " + std::string(defect.name), paper};
    variant.config.defects.*defect.on = true;
    variants.push_back(std::move(variant));
  }
  PublishedVariant figures{"+ its figures", localization::published_config()};
  figures.config.defects = {};
  variants.push_back(std::move(figures));
  variants.push_back({"published", localization::published_config()});
  return variants;
}

void VariantScore::add(const LocalizerMetrics& metrics) {
  events += metrics.events;
  recovered += metrics.recovered;
  for (const RecoveryWindow& window : metrics.windows) {
    if (window.recovered) {
      time_s.push_back(localization::seconds(*window.recovered - window.begin));
    }
  }
  if (metrics.tracking_error_m) tracking_m.push_back(metrics.tracking_error_m->mean);
  if (metrics.wrong_lock_share) wrong.push_back(*metrics.wrong_lock_share);
}

}  // namespace castaway::testbed
