#include "localization/search/rescue.hpp"

#include <algorithm>

namespace castaway::localization {

std::optional<WeighedPlace> Rescue::find(const CreateContext& context, const Hypothesis& output,
                                         double usual, const ScanPoints& points) const {
  const SE2& centre = output.belief.mean;
  const double now = context.evidence.evaluate(points, centre).log_likelihood;
  if (now > usual - config_.drop) return std::nullopt;
  const MatchWindow window{centre, config_.radius, config_.yaw_radius};
  std::vector<Candidate> candidates = matcher_.match(points, window);
  candidates.resize(std::min(candidates.size(), static_cast<std::size_t>(config_.candidates)));
  const std::vector<WeighedPlace> places = refine_candidates(context, candidates, points);
  if (places.empty() || places[0].newest.log_likelihood < now + config_.gain) return std::nullopt;
  const Evidence before{output.log_likelihood, output.quality};
  return WeighedPlace{places[0].T_map_base, before, output.log_weight - config_.cost};
}

}  // namespace castaway::localization
