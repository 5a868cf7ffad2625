#include "python/src/evaluate.hpp"

#include <pybind11/stl.h>
#include <nlohmann/json.hpp>

#include "python/src/python_localizer.hpp"
#include "python/src/signals.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/batch/evaluate/evaluation.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::python {
namespace {

namespace py = pybind11;
using testbed::EvaluationConfig;
using testbed::RecordedPlace;

/// One localizer on one log. Returns a JSON object, as `castaway evaluate --json` prints it.
std::string evaluate(const RecordedPlace& place, const testbed::LocalizerSpec& spec,
                     const EvaluationConfig& config) {
  const py::gil_scoped_release no_gil;
  EvaluationConfig watched = config;
  watched.on_scan = &check_signals;
  return testbed::json_text(to_json(testbed::evaluate(place, spec, watched)));
}

testbed::LocalizerSpec python_spec(const std::string& name, const py::object& localizer) {
  return {name, python_config(localizer)};
}

RecordedPlace load_place(const std::string& folder,
                         const std::vector<testbed::LocalizerSpec>& localizers,
                         const std::string& map3d) {
  const testbed::PlaceMaps maps = testbed::maps_for(localizers, {map3d, {}});
  const py::gil_scoped_release no_gil;
  return testbed::load_recorded_place(folder, maps);
}

void bind_config(py::module_& module) {
  py::class_<EvaluationConfig>(module, "EvaluationConfig", "Trials of an evaluation.")
      .def(py::init())
      .def_readwrite("starts", &EvaluationConfig::starts)
      .def_readwrite("kidnaps", &EvaluationConfig::kidnaps)
      .def_readwrite("window_s", &EvaluationConfig::window_s)
      .def_readwrite("tracking", &EvaluationConfig::tracking)
      .def_readwrite("seed", &EvaluationConfig::seed)
      .def_property(
          "kidnap_to", [](const EvaluationConfig&) { return py::none(); },
          [](EvaluationConfig& config, const std::string& kind) {
            config.kidnap_to = testbed::parse_splice_kind(kind);
          });
}

}  // namespace

void bind_evaluate(py::module_& module) {
  bind_config(module);
  py::class_<testbed::LocalizerSpec>(module, "LocalizerSpec", "A localizer of an evaluation.")
      .def(py::init(&testbed::parse_localizer), py::arg("text"))
      .def(py::init(&python_spec), py::arg("name"), py::arg("localizer"))
      .def_readonly("name", &testbed::LocalizerSpec::name);
  py::class_<RecordedPlace>(module, "RecordedPlace", "A log with its map.")
      .def(py::init(&load_place), py::arg("folder"), py::arg("localizers"), py::arg("map3d"));
  module.def("evaluate", &evaluate, py::arg("place"), py::arg("localizer"), py::arg("config"),
             "All trials of one localizer on one log, as a JSON object.");
}

}  // namespace castaway::python
