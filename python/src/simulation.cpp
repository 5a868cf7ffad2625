#include "python/src/simulation.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include <pybind11/stl.h>

#include "public/read_scenario.hpp"
#include "python/src/arrays.hpp"
#include "python/src/frames.hpp"
#include "python/src/map.hpp"
#include "python/src/one_thread.hpp"
#include "python/src/scan.hpp"
#include "sim/casting/surfaces.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/scan_truth.hpp"
#include "tools/build/simulator_source.hpp"

namespace castaway::python {
namespace {

/// The simulation of a scenario, without its localizers.
class Simulation {
 public:
  explicit Simulation(const Scenario& asked) {
    const ReadScenario read = read_scenario(asked);
    const py::gil_scoped_release no_gil;
    const testbed::Scenario& scenario = read.loaded.scenario;
    testbed::PreparedSimulation prepared =
        testbed::build_simulation(scenario, read.file.parent_path());
    effective_ = read.loaded.effective;
    warnings_ = std::move(prepared.warnings);
    world_ = prepared.config.world;
    lidars_ = testbed::lidars_of(prepared.config.lidars);
    map_ = std::make_shared<Map>(std::move(prepared.map));
    source_ = testbed::build_source(scenario, std::move(prepared.config));
  }

  py::object next() {
    const OneThread::Use use(thread_);
    std::optional<testbed::Frame> frame;
    {
      const py::gil_scoped_release no_gil;
      frame = source_->next();
    }
    if (!frame) throw py::stop_iteration();
    return to_python(std::move(*frame));
  }
  void command(double v, double w) {
    if (!std::isfinite(v) || !std::isfinite(w)) {
      throw std::invalid_argument("v and w must be finite numbers");
    }
    const OneThread::Use use(thread_);
    source_->set_command(sim::Twist2{v, w});
  }
  void follow_route() {
    const OneThread::Use use(thread_);
    source_->set_command(std::nullopt);
  }
  void kidnap(const py::object& pose) {
    const OneThread::Use use(thread_);
    source_->kidnap(to_pose(pose, "pose"));
  }
  void set_estimate(const py::object& pose) {
    const OneThread::Use use(thread_);
    const std::optional<SE2> T_map_base = to_optional_pose(pose, "pose");
    source_->set_drive_pose(T_map_base);
    source_->set_watched_pose(T_map_base, 0.0);
  }
  [[nodiscard]] py::object start_pose() {
    const OneThread::Use use(thread_);
    return python::to_python(source_->start_pose());
  }
  [[nodiscard]] double duration_s() const { return localization::seconds(source_->duration()); }
  [[nodiscard]] std::string label_name(int label) const { return sim::hit_name(world_, label); }
  [[nodiscard]] const SharedMap& map() const { return map_; }
  [[nodiscard]] const std::vector<testbed::LidarFacts>& lidars() const { return lidars_; }
  [[nodiscard]] const std::string& scenario() const { return effective_; }
  [[nodiscard]] std::vector<std::string> warnings() {
    const OneThread::Use use(thread_);
    std::vector<std::string> all = warnings_;
    for (std::string& warning : source_->warnings()) all.push_back(std::move(warning));
    return all;
  }

 private:
  OneThread thread_;
  std::string effective_;
  std::vector<std::string> warnings_;
  sim::WorldSpec world_;
  std::vector<testbed::LidarFacts> lidars_;
  SharedMap map_;
  std::unique_ptr<testbed::SimulatorSource> source_;
};

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<Simulation>(module, "NativeSimulation", "The simulation of a scenario.")
      .def(py::init<const Scenario&>(), py::arg("request"))
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &Simulation::next)
      .def("command", &Simulation::command, py::arg("v"), py::arg("w"))
      .def("follow_route", &Simulation::follow_route)
      .def("kidnap", &Simulation::kidnap, py::arg("pose"))
      .def("set_estimate", &Simulation::set_estimate, py::arg("pose"))
      .def("label_name", &Simulation::label_name, py::arg("label"))
      .def_property_readonly("start_pose", &Simulation::start_pose)
      .def_property_readonly("duration_s", &Simulation::duration_s)
      .def_property_readonly("map", &Simulation::map)
      .def_property_readonly("lidars", &Simulation::lidars)
      .def_property_readonly("scenario", &Simulation::scenario)
      .def_property_readonly("warnings", &Simulation::warnings);
}

}  // namespace castaway::python
