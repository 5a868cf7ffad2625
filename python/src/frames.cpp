#include "python/src/frames.hpp"

#include <array>
#include <memory>
#include <variant>

#include <pybind11/stl.h>

#include "python/src/arrays.hpp"
#include "python/src/scan.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::python {
namespace {

using testbed::OdometryFrame;
using testbed::RunEvent;

/// A scan with its truth.
struct PythonScanFrame {
  localization::Stamp stamp{};
  SharedScan scan;
  testbed::ScanFrame rest;  ///< Without the scan.
};

/// An odometry reading with its truth.
struct PythonOdometryFrame {
  OdometryFrame frame;
};

/// A reading of an inertial measurement unit.
struct PythonImuFrame {
  testbed::ImuFrame frame;
};

/// A row of `ScanFrame.people`.
struct PersonRow {
  std::int64_t id;
  double x_m, y_m, yaw_rad, vx_m_per_s, vy_m_per_s, gap_m;
};

py::array_t<PersonRow> people_of(const PythonScanFrame& frame) {
  const auto& people = frame.rest.people.people;
  py::array_t<PersonRow> rows(static_cast<py::ssize_t>(people.size()));
  PersonRow* row = rows.mutable_data();
  for (const testbed::PersonTruth& person : people) {
    const SE2& pose = person.T_map_person;
    *row++ = {person.id,           pose.x,      pose.y, pose.yaw, person.velocity.x(),
              person.velocity.y(), person.gap_m};
  }
  return rows;
}

template <typename T>
py::array_t<T> view_of_vector(const std::vector<T>& values, const py::object& self) {
  return view_of(values.data(), {static_cast<py::ssize_t>(values.size())}, self);
}

void bind_odometry(py::module_& module) {
  using Frame = PythonOdometryFrame;
  py::class_<Frame>(module, "OdometryFrame", "A reading of wheel odometry, with its truth.")
      .def_property_readonly(
          "stamp_ns", [](const Frame& f) { return f.frame.odometry.stamp.count(); }, "[ns]")
      .def_property_readonly(
          "pose", [](const Frame& f) { return to_python(f.frame.odometry.T_odom_base); },
          "(x [m], y [m], yaw [rad]) of base in odom.")
      .def_property_readonly(
          "truth", [](const Frame& f) { return to_python(T_map_base_of(f.frame.true_pose)); },
          "True pose of base in map.");
}

void bind_imu(py::module_& module) {
  using Frame = PythonImuFrame;
  const auto tuple_of = [](const Eigen::Vector3d& v) { return std::array{v.x(), v.y(), v.z()}; };
  py::class_<Frame>(module, "ImuFrame", "A reading of an inertial measurement unit, in base.")
      .def_property_readonly(
          "stamp_ns", [](const Frame& f) { return f.frame.imu.stamp.count(); }, "[ns]")
      .def_property_readonly(
          "angular_velocity",
          [tuple_of](const Frame& f) {
            return py::tuple(py::cast(tuple_of(f.frame.imu.angular_velocity)));
          },
          "(x, y, z) [rad/s]")
      .def_property_readonly(
          "linear_acceleration",
          [tuple_of](const Frame& f) {
            return py::tuple(py::cast(tuple_of(f.frame.imu.linear_acceleration)));
          },
          "(x, y, z) [m/s^2] Specific force: at rest on level ground (0, 0, 9.81).");
}

void bind_scan_frame(py::module_& module) {
  using Frame = PythonScanFrame;
  PYBIND11_NUMPY_DTYPE(PersonRow, id, x_m, y_m, yaw_rad, vx_m_per_s, vy_m_per_s, gap_m);
  py::class_<Frame>(module, "ScanFrame", "A scan, delivered at the time of its last beam.")
      .def_property_readonly(
          "stamp_ns", [](const Frame& f) { return f.stamp.count(); },
          "[ns] Time of delivery; the scan's own is that of its first beam.")
      .def_readonly("scan", &Frame::scan)
      .def_property_readonly(
          "truth", [](const Frame& f) { return to_python(T_map_base_of(f.rest.true_pose)); },
          "True pose of base in map at the scan's stamp.")
      .def_property_readonly("people", &people_of,
                             "Structured array: id, x_m, y_m, yaw_rad, vx_m_per_s, vy_m_per_s, "
                             "gap_m (between robot and person; <= 0: contact).")
      .def_property_readonly(
          "beams_on_people", [](const Frame& f) { return f.rest.people.beams_on_people; },
          "Share of the beams that hit people.")
      .def_property_readonly(
          "labels",
          [](const py::object& self) {
            return view_of_vector(self.cast<const Frame&>().rest.truth.labels, self);
          },
          "By beam: what it hit (`Simulation.label_name`).")
      .def_property_readonly(
          "intensities",
          [](const py::object& self) {
            return view_of_vector(self.cast<const Frame&>().rest.truth.intensities, self);
          },
          "By beam; empty if the lidar reports none.");
}

void bind_event(py::module_& module) {
  py::class_<RunEvent>(module, "Event", "Something that happened to the robot.")
      .def_property_readonly(
          "stamp_ns", [](const RunEvent& e) { return e.stamp.count(); }, "[ns]")
      .def_property_readonly(
          "kind", [](const RunEvent& e) { return names_of(e.what).kind; },
          "'kidnap', 'pick-up', 'collision', 'fault on', ...")
      .def_property_readonly("detail", [](const RunEvent& e) { return names_of(e.what).detail; })
      .def_property_readonly(
          "pose_from", [](const RunEvent& e) { return to_python(e.T_map_from); },
          "True pose of base in map before.")
      .def_property_readonly(
          "pose_to", [](const RunEvent& e) { return to_python(e.T_map_to); },
          "True pose of base in map after.");
}

}  // namespace

py::object to_python(testbed::Frame frame) {
  if (auto* event = std::get_if<RunEvent>(&frame.data)) return py::cast(std::move(*event));
  if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    return py::cast(PythonOdometryFrame{*odometry});
  }
  if (auto* imu = std::get_if<testbed::ImuFrame>(&frame.data))
    return py::cast(PythonImuFrame{*imu});
  auto& taken = std::get<testbed::ScanFrame>(frame.data);
  auto scan = std::make_shared<localization::LaserScan>(std::move(taken.scan));
  return py::cast(PythonScanFrame{frame.stamp, std::move(scan), std::move(taken)});
}

void bind_frames(py::module_& module) {
  bind_odometry(module);
  bind_imu(module);
  bind_scan_frame(module);
  bind_event(module);
}

}  // namespace castaway::python
