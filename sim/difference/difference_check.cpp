#include <stdexcept>

#include <fmt/format.h>

#include "sim/difference/difference.hpp"

namespace castaway::sim {

bool DifferenceSpec::empty() const {
  return changes.empty() && move_furniture == 0.0 && remove == 0.0 && close_doors == 0.0 &&
         open_doors == 0.0 && add_boxes == 0;
}

void validate(const DifferenceSpec& spec) {
  for (const double share : {spec.move_furniture, spec.remove, spec.close_doors, spec.open_doors}) {
    if (!(share >= 0.0 && share <= 1.0)) {
      throw std::invalid_argument(
          fmt::format("differences: {} is not a share: give 0 to 1", share));
    }
  }
  if (!(spec.reach_m > 0.0 && spec.reach_m <= 100.0)) {
    throw std::invalid_argument(
        fmt::format("differences: reach_m is {}: give above 0 to 100 m", spec.reach_m));
  }
  if (spec.add_boxes < 0 || spec.add_boxes > 1000) {
    throw std::invalid_argument(
        fmt::format("differences: add_boxes is {}: give 0 to 1000", spec.add_boxes));
  }
}

}  // namespace castaway::sim
