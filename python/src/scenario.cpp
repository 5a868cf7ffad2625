#include "python/src/scenario.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "castaway/scenario.hpp"
#include "sim/render/renderer_variables.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::python {

namespace py = pybind11;

void bind_scenario(py::module_& module) {
  py::class_<Scenario>(module, "ScenarioRequest", "A scenario with its changes.")
      .def(py::init<std::string, std::vector<std::string>, bool>(), py::arg("scenario"),
           py::arg("overrides"), py::arg("allow_programs"));
  module.def("set_shipped_data", &set_data_folder, py::arg("folder"),
             "Where worlds, robots, lidars and data sets lie, unless CASTAWAY_DATA says it.");
  module.def("use_renderer_in", &sim::use_renderer_in, py::arg("folder"),
             "Takes Mesa's software renderer in the folder for all pictures.");
  module.def("data_root", &testbed::data_root, "Where worlds, robots, lidars and data sets lie.");
  module.def("scenarios", &scenario_names, "The scenarios that come along.");
  module.def("localizer_yaml", &testbed::localizer_yaml, py::arg("text"),
             "A localizer of the command line (NAME:PRESET, program:..., library:...) as YAML.");
  module.def("file_name_of", &testbed::file_name_of, py::arg("text"),
             "The text with all characters replaced that cannot be in a file's name.");
}

}  // namespace castaway::python
