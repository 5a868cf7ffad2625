#include "python/src/run.hpp"

#include <map>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/src/python_localizer.hpp"
#include "python/src/scenario.hpp"
#include "python/src/signals.hpp"
#include "tools/pages/run/report.hpp"
#include "tools/play/play.hpp"
#include "tools/play/verdict_output.hpp"

namespace castaway::python {
namespace {

namespace py = pybind11;
using testbed::PlayOptions;

/// Localizers of Python, by their names in the scenario.
using PythonLocalizers = std::map<std::string, py::object>;

/// What is left of a run besides its folder.
struct Played {
  std::map<std::string, std::string> failed;  ///< What went wrong, by localizer.
  std::vector<std::string> missed;            ///< Expectations that were not met, a sentence each.
  std::vector<std::string> warnings;
};

void add_localizers(const PythonLocalizers& localizers, testbed::Scenario& scenario) {
  for (testbed::LocalizerSpec& spec : scenario.localizers) {
    const auto found = localizers.find(spec.name);
    if (found != localizers.end()) spec.config = python_config(found->second);
  }
}

PlayOptions play_options(const ReadScenario& read, const std::filesystem::path& out, bool force,
                         Played& played) {
  PlayOptions options;
  options.base = read.file.parent_path();
  options.inputs = inputs_of(read.loaded.scenario, read.file);
  options.out = out;
  options.force = force;
  options.quiet = true;
  options.report = testbed::write_report;
  options.warn = [&played](const std::string& warning) { played.warnings.push_back(warning); };
  options.watcher = [] { return std::make_unique<SignalSink>(); };
  return options;
}

std::vector<std::string> missed_by(const testbed::Scenario& scenario,
                                   const std::filesystem::path& folder) {
  std::vector<std::string> missed;
  if (scenario.expect.empty()) return missed;
  for (const testbed::Check& check : judge(scenario.expect, {testbed::load_judged_run(folder)})) {
    if (!check.met) missed.push_back(describe(check));
  }
  return missed;
}

Played play(const ScenarioRequest& request, const PythonLocalizers& localizers,
            const std::filesystem::path& out, bool force) {
  ReadScenario read = read_scenario(request);
  add_localizers(localizers, read.loaded.scenario);
  Played played;
  const PlayOptions options = play_options(read, out, force, played);
  const py::gil_scoped_release no_gil;
  for (const auto& lost : play_to_the_end(read.loaded, options)) {
    played.failed[lost.name] = lost.what;
  }
  played.missed = missed_by(read.loaded.scenario, out);
  return played;
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<Played>(module, "Played", "What is left of a run besides its folder.")
      .def_readonly("failed", &Played::failed, "What went wrong, by localizer.")
      .def_readonly("missed", &Played::missed, "Expectations that were not met.")
      .def_readonly("warnings", &Played::warnings);
  module.def("play", &play, py::arg("request"), py::arg("localizers"), py::arg("out"),
             py::arg("force"), "Simulates a scenario and leaves its files in the folder `out`.");
  module.def("write_report", &testbed::remake_report, py::arg("folder"),
             "Writes report.html of a run folder.");
}

}  // namespace castaway::python
