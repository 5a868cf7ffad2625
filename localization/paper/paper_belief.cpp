#include "localization/paper/paper_belief.hpp"

#include <limits>

#include "localization/hypotheses/null_hypothesis.hpp"

namespace castaway::localization {

int Patience::settle(std::optional<int> present, int preferred, Stamp now) {
  if (present == preferred) {
    since_.reset();
    return preferred;
  }
  if (!since_) since_ = now;
  if (present && seconds(now - *since_) < wait_s_) return *present;
  since_.reset();
  return preferred;
}

PaperBelief::PaperBelief(const PaperMhAmclConfig& config, double patience_s, std::uint64_t seed)
    : spawner(config.spawn, config.size, seed), patience(patience_s) {}

void PaperBelief::clear() {
  populations = {};
  patience.reset();
}

Hypothesis& PaperBelief::add(const PoseMoments& belief) {
  return populations.all.emplace_back(spawner.spawn(belief, 0.0, {}));
}

void PaperBelief::select(int preferred, Stamp now) {
  std::optional<int> present;
  if (populations.output() != nullptr) present = populations.output_id;
  populations.output_id = patience.settle(present, preferred, now);
  update_probability();
}

void PaperBelief::update_probability() {
  if (const Hypothesis* output = populations.output()) populations.probability = output->quality;
}

std::vector<double> PaperBelief::shares() const {
  return localization::shares(populations.all,
                              {.log_weight = -std::numeric_limits<double>::infinity()});
}

}  // namespace castaway::localization
