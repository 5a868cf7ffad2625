#include "python/src/run.hpp"

#include <map>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "public/play.hpp"
#include "python/src/python_localizer.hpp"
#include "python/src/signals.hpp"
#include "tools/pages/run/report.hpp"

namespace castaway::python {
namespace {

namespace py = pybind11;
/// Localizers of Python, by their names in the scenario.
using PythonLocalizers = std::map<std::string, py::object>;

RunResult play_in_python(const Scenario& scenario, const PythonLocalizers& localizers,
                         const std::filesystem::path& out, bool force) {
  PlayRequest request{out, force};
  for (const auto& [name, localizer] : localizers) request.own[name] = python_config(localizer);
  request.watcher = [] { return std::make_unique<SignalSink>(); };
  const py::gil_scoped_release no_gil;
  return play(scenario, request);
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<RunResult>(module, "Played", "What is left of a run besides its folder.")
      .def_readonly("failed", &RunResult::failed, "What went wrong, by localizer.")
      .def_readonly("missed", &RunResult::missed, "Expectations that were not met.")
      .def_readonly("warnings", &RunResult::warnings);
  module.def("play", &play_in_python, py::arg("request"), py::arg("localizers"), py::arg("out"),
             py::arg("force"), "Simulates a scenario and leaves its files in the folder `out`.");
  module.def("write_report", &testbed::remake_report, py::arg("folder"),
             "Writes report.html of a run folder.");
}

}  // namespace castaway::python
