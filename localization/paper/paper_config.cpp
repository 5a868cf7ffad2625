#include "localization/paper/paper_config.hpp"

#include <stdexcept>
#include <string>

namespace castaway::localization {

void validate(const PaperMhAmclConfig& config) {
  const auto require_positive = [](double value, const char* name) {
    if (!(value > 0.0)) throw std::invalid_argument(std::string(name) + " must be positive");
  };
  require_positive(config.predict_rate_hz, "predict_rate_hz");
  require_positive(config.correct_rate_hz, "correct_rate_hz");
  require_positive(config.reseed_rate_hz, "reseed_rate_hz");
  require_positive(config.match_period_s, "match_period_s");
  validate(config.beams);
  validate(config.motion);
  validate(config.reseed);
  validate(config.size);
}

}  // namespace castaway::localization
