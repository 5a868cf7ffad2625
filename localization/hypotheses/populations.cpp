#include "localization/hypotheses/populations.hpp"

#include <algorithm>

namespace castaway::localization {

const Hypothesis* Populations::output() const {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Hypothesis& h) { return h.id == output_id; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace castaway::localization
