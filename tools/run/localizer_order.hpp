/// What an operator does to a localizer during a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "castaway/localizer.hpp"

namespace castaway::testbed {

/// An order takes place after the last delivery at or before `at`.
struct LocalizerOrder {
  enum class What : std::uint8_t {
    kInitialize,  ///< Restarts it at `pose`.
    kRelocalize,  ///< Restarts it anywhere on the map: global localization.
    kOff,         ///< It gets no data and has no estimate.
    kOn,          ///< Starts it again, anywhere on the map.
  };

  localization::Stamp at{};
  std::string localizer;
  What what = What::kRelocalize;
  std::optional<localization::PoseWithCovariance> pose{};  ///< Of kInitialize, of base in map.
};

}  // namespace castaway::testbed
