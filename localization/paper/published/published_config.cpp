#include "localization/paper/published/published_config.hpp"

namespace castaway::localization {

PublishedMhAmclConfig published_config() {
  PublishedMhAmclConfig config;
  config.defects = all_defects();
  PaperMhAmclConfig& paper = config.paper;
  paper.candidate_sigma = 0.1;
  paper.candidate_sigma_yaw = 0.05;
  paper.reseed.winners = 0.03;
  paper.reseed.spread_m = paper.candidate_sigma;
  paper.reseed.spread_rad = paper.candidate_sigma_yaw;
  return config;
}

}  // namespace castaway::localization
