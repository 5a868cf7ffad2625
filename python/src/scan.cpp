#include "python/src/scan.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "python/src/arrays.hpp"
#include "tools/build/foreign/message_text.hpp"  // Lidar facts.

namespace castaway::python {
namespace {

using localization::LaserScan;
using testbed::LidarFacts;

using Ranges = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Matrix = py::array_t<double, py::array::c_style | py::array::forcecast>;

Eigen::Isometry3d to_isometry(const py::object& value) {
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  if (value.is_none()) return transform;
  const Matrix matrix = Matrix::ensure(value);
  if (!matrix) throw py::error_already_set();
  if (matrix.ndim() != 2 || matrix.shape(0) != 4 || matrix.shape(1) != 4) {
    throw std::invalid_argument("T_base_laser must be a 4 x 4 matrix");
  }
  if (!std::all_of(matrix.data(), matrix.data() + matrix.size(),
                   [](double x) { return std::isfinite(x); })) {
    throw std::invalid_argument("T_base_laser must be finite");
  }
  transform.matrix() =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix.data());
  return transform;
}

SharedScan make_scan(const Ranges& ranges, std::int64_t stamp_ns, double angle_min,
                     double angle_increment, double range_min, double range_max,
                     double time_increment_s, const py::object& T_base_laser, std::string lidar) {
  for (const double number : {angle_min, angle_increment, range_min, range_max, time_increment_s}) {
    if (std::isfinite(number)) continue;
    throw std::invalid_argument(
        "angle_min, angle_increment, range_min, range_max and time_increment_s must be finite");
  }
  auto scan = std::make_shared<LaserScan>();
  scan->stamp = localization::Stamp(stamp_ns);
  scan->time_increment = localization::from_seconds(time_increment_s);
  scan->angle_min = angle_min;
  scan->angle_increment = angle_increment;
  scan->range_min = range_min;
  scan->range_max = range_max;
  scan->ranges.assign(ranges.data(), ranges.data() + ranges.size());
  scan->T_base_laser = to_isometry(T_base_laser);
  scan->lidar = std::move(lidar);
  return scan;
}

py::array_t<float> ranges_of(const py::object& self) {
  const LaserScan& scan = self.cast<const LaserScan&>();
  return view_of(scan.ranges.data(), {static_cast<py::ssize_t>(scan.ranges.size())}, self);
}

py::array_t<double> angles_of(const LaserScan& scan) {
  py::array_t<double> angles(static_cast<py::ssize_t>(scan.ranges.size()));
  double* values = angles.mutable_data();
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) values[i] = scan.beam_angle(i);
  return angles;
}

void bind_lidar(py::module_& module) {
  py::class_<LidarFacts>(module, "Lidar", "What the scans of a lidar have in common.")
      .def_readonly("name", &LidarFacts::name, "As in its scans; empty if there is one lidar.")
      .def_readonly("angle_min", &LidarFacts::angle_min, "[rad] Of the first beam.")
      .def_readonly("angle_increment", &LidarFacts::angle_increment, "[rad] Signed.")
      .def_readonly("range_min", &LidarFacts::range_min, "[m]")
      .def_readonly("range_max", &LidarFacts::range_max, "[m]")
      .def_readonly("beams", &LidarFacts::beams, "Number of beams.")
      .def_property_readonly(
          "T_base_laser",
          [](const LidarFacts& lidar) { return to_array(lidar.T_base_laser.matrix()); },
          "The lidar's mount, 4 x 4.");
}

}  // namespace

void bind_scan(py::module_& module) {
  bind_lidar(module);
  py::class_<LaserScan, SharedScan>(module, "Scan", "One sweep of a planar lidar with any mount.")
      .def(py::init(&make_scan), py::arg("ranges"), py::kw_only(), py::arg("stamp_ns"),
           py::arg("angle_min"), py::arg("angle_increment"), py::arg("range_min"),
           py::arg("range_max"), py::arg("time_increment_s") = 0.0,
           py::arg("T_base_laser") = py::none(), py::arg("lidar") = "")
      .def_property_readonly(
          "stamp_ns", [](const LaserScan& scan) { return scan.stamp.count(); },
          "[ns] Time of the first beam.")
      .def_property_readonly(
          "time_increment_s",
          [](const LaserScan& scan) { return localization::seconds(scan.time_increment); },
          "[s] Between two beams; 0 if all were taken at once.")
      .def_readonly("angle_min", &LaserScan::angle_min, "[rad] About the lidar's z, from its x.")
      .def_readonly("angle_increment", &LaserScan::angle_increment, "[rad] Signed.")
      .def_readonly("range_min", &LaserScan::range_min, "[m] Shorter returns are invalid.")
      .def_readonly("range_max", &LaserScan::range_max, "[m] Longer returns are invalid.")
      .def_readonly("lidar", &LaserScan::lidar, "Name of the lidar if there are several.")
      .def_property_readonly("ranges", &ranges_of,
                             "[m] float32, a view: inf no return, -inf too close, nan invalid.")
      .def_property_readonly("angles", &angles_of, "[rad] Of the beams.")
      .def_property_readonly(
          "T_base_laser",
          [](const LaserScan& scan) { return to_array(scan.T_base_laser.matrix()); },
          "The lidar's mount, 4 x 4.")
      .def("__len__", [](const LaserScan& scan) { return scan.ranges.size(); });
}

}  // namespace castaway::python
