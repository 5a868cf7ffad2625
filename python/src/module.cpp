// The module _castaway: what the Python package needs from C++.
#include <pybind11/pybind11.h>

#include "python/src/errors.hpp"
#include "python/src/estimate.hpp"
#include "python/src/evaluate.hpp"
#include "python/src/frames.hpp"
#include "python/src/map.hpp"
#include "python/src/native_localizer.hpp"
#include "python/src/python_localizer.hpp"
#include "python/src/run.hpp"
#include "python/src/scan.hpp"
#include "python/src/scenario.hpp"
#include "python/src/signals.hpp"
#include "python/src/simulation.hpp"

PYBIND11_MODULE(_castaway, module) {
  using namespace castaway::python;
  module.doc() = "castaway's C++.";
  module.attr("__version__") = CASTAWAY_VERSION;
  bind_errors(module);
  translate_raised();
  bind_scan(module);
  bind_map(module);
  bind_estimate(module);
  bind_native_localizer(module);
  bind_setup(module);
  bind_scenario(module);
  bind_run(module);
  bind_frames(module);
  bind_simulation(module);
  bind_evaluate(module);
}
