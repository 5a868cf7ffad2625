#include "localization/paper/paper_config.hpp"

#include <stdexcept>

namespace castaway::localization {

void validate(const PaperMhAmclConfig& config) {
  validate(config.input);
  if (!(config.match_period_s > 0.0)) {
    throw std::invalid_argument("match_period_s must be positive");
  }
  validate(config.motion);
  validate(config.reseed);
  validate(config.size);
}

}  // namespace castaway::localization
