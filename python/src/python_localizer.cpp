#include "python/src/python_localizer.hpp"

#include <stdexcept>
#include <utility>

#include <pybind11/stl.h>

#include "python/src/arrays.hpp"
#include "python/src/estimate.hpp"
#include "python/src/map.hpp"
#include "python/src/scan.hpp"
#include "tools/build/foreign/message_text.hpp"
#include "tools/build/foreign/odometry_twist.hpp"

namespace castaway::python {
namespace {

/// What a localizer is told once.
struct Setup {
  std::string name;
  std::uint64_t seed = 0;
  SharedMap map;
  std::vector<testbed::LidarFacts> lidars;
};

/// A class, or another callable, makes the localizer.
py::object made_of(const py::object& localizer_or_factory) {
  const bool is_localizer =
      !PyType_Check(localizer_or_factory.ptr()) && py::hasattr(localizer_or_factory, "on_scan");
  return is_localizer ? localizer_or_factory : localizer_or_factory();
}

std::string type_name(const py::handle& object) {
  return py::type::of(object).attr("__name__").cast<std::string>();
}

}  // namespace

HeldObject hold(py::object object) {
  return {new py::object(std::move(object)), [](py::object* held) {
            const py::gil_scoped_acquire gil;
            delete held;
          }};
}

PythonLocalizer::PythonLocalizer(HeldObject localizer, const testbed::Greeting& greeting)
    : localizer_(std::move(localizer)), name_(greeting.name) {
  if (!py::hasattr(*localizer_, "setup")) return;
  localizer_->attr("setup")(
      Setup{greeting.name, greeting.seed, std::make_shared<Map>(greeting.map), greeting.lidars});
}

void PythonLocalizer::initialize(const std::optional<localization::PoseWithCovariance>& start) {
  const py::gil_scoped_acquire gil;
  answer_ = {};
  if (start) {
    localizer_->attr("initialize")(to_python(start->T_map_base), to_array(start->covariance));
  } else {
    localizer_->attr("initialize")(py::none(), py::none());
  }
}

void PythonLocalizer::on_odometry(const localization::Odometry& odometry) {
  const py::gil_scoped_acquire gil;
  const Eigen::Vector3d twist = testbed::twist_between(before_, odometry);
  before_ = odometry;
  localizer_->attr("on_odometry")(odometry.stamp.count(), to_python(odometry.T_odom_base),
                                  py::make_tuple(twist.x(), twist.y(), twist.z()));
}

/// Python may keep the scan: it gets the only copy.
void PythonLocalizer::on_scan(const localization::LaserScan& scan) {
  const py::gil_scoped_acquire gil;
  answer_ = {};
  const py::object answer =
      localizer_->attr("on_scan")(std::make_shared<localization::LaserScan>(scan));
  if (answer.is_none()) return;
  if (!py::isinstance<StatedEstimate>(answer)) {
    throw py::type_error("localizer '" + name_ + "': on_scan returned '" + type_name(answer) +
                         "': return a castaway.Estimate or None");
  }
  answer_ = to_answer(answer.cast<const StatedEstimate&>(), scan.stamp);
}

localization::Diagnostics PythonLocalizer::diagnostics() const {
  localization::Diagnostics diagnostics;
  diagnostics.populations = answer_.populations;
  return diagnostics;
}

testbed::OwnConfig python_config(py::object localizer_or_factory) {
  return {[held = hold(std::move(localizer_or_factory))](
              const testbed::Greeting& greeting) -> std::unique_ptr<localization::Localizer> {
    const py::gil_scoped_acquire gil;
    return std::make_unique<PythonLocalizer>(hold(made_of(*held)), greeting);
  }};
}

void bind_setup(py::module_& module) {
  py::class_<Setup>(module, "Setup", "What a localizer is told once, before the run.")
      .def_readonly("name", &Setup::name, "Of the localizer in the run.")
      .def_readonly("seed", &Setup::seed, "Root of its random numbers.")
      .def_readonly("map", &Setup::map, "The localizers' map.")
      .def_readonly("lidars", &Setup::lidars, "Those that are known before the run.");
}

}  // namespace castaway::python
