/// `Estimate`: what a localizer of Python answers to a scan.
#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "castaway/localizer.hpp"
#include "tools/build/foreign/answer.hpp"

namespace castaway::python {

/// An estimate without its stamp, which is that of the scan.
struct StatedEstimate {
  localization::Estimate estimate;
  std::vector<localization::Alternative> hypotheses;  ///< As in docs/protocol.md.
};

/// What C++ makes of it. @throws std::invalid_argument for values that cannot be.
testbed::Answer to_answer(const StatedEstimate& stated, localization::Stamp stamp);

/// What Python sees of an estimate of C++ and of its populations.
StatedEstimate to_stated(const localization::Estimate& estimate,
                         const localization::Diagnostics& diagnostics);

void bind_estimate(pybind11::module_& module);

}  // namespace castaway::python
