#include "localization/hypotheses/lost_and_found.hpp"

namespace castaway::localization {

void LostAndFound::start(bool known) {
  found_ = known;
  was_found_ = known;
  T_odom_jump_.reset();
}

/// A robot that was found and not kidnapped is still at its place. If the output jumps
/// nevertheless, one of the two outputs is wrong because of the map, so the new one must be
/// confirmed by motion.
void LostAndFound::take(const OutputClaim& output, double cue,
                        const std::optional<SE2>& T_odom_base) {
  if (!output.same) {
    const bool is_explained = cue >= config_.unexplained_cue;
    T_odom_jump_ = was_found_ && !is_explained ? T_odom_base : std::nullopt;
  }
  const double least = found_ && output.same ? config_.stays : config_.found;
  found_ = output.confident && is_proven(T_odom_base) && output.probability >= least;
  was_found_ = was_found_ || found_;
}

bool LostAndFound::is_proven(const std::optional<SE2>& T_odom_base) const {
  return !T_odom_jump_ || distance(*T_odom_jump_, *T_odom_base) >= config_.proving_m;
}

}  // namespace castaway::localization
