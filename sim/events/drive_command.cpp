#include "sim/events/drive_command.hpp"

#include <cmath>
#include <stdexcept>

namespace castaway::sim {

void validate(const DriveCommand& command) {
  if (!(command.at_s >= 0.0)) {
    throw std::invalid_argument("drive: at_s must not be negative");
  }
  if (command.twist && !(std::isfinite(command.twist->v) && std::isfinite(command.twist->w))) {
    throw std::invalid_argument("drive: v and w must be finite");
  }
}

}  // namespace castaway::sim
