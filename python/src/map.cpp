#include "python/src/map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <pybind11/stl/filesystem.h>

#include "localization/map/ray_cast.hpp"
#include "python/src/arrays.hpp"
#include "tools/scenario/files/ros_map_file.hpp"

namespace castaway::python {
namespace {

using testbed::RosMap;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The cells of an array of any type. @throws std::invalid_argument if one is no whole number from
/// -1 to 100: a probability or a grey value would be cut.
std::vector<std::int8_t> to_cells(const Numbers& numbers) {
  std::vector<std::int8_t> cells;
  cells.reserve(static_cast<std::size_t>(numbers.size()));
  for (const double* value = numbers.data(); value != numbers.data() + numbers.size(); ++value) {
    if (*value < -1.0 || *value > 100.0 || std::trunc(*value) != *value) {
      throw std::invalid_argument("cells must be whole numbers from -1 to 100, not " +
                                  py::str(py::float_(*value)).cast<std::string>() +
                                  ": -1 unknown, 0 free ... 100 occupied");
    }
    cells.push_back(static_cast<std::int8_t>(*value));
  }
  return cells;
}

bool all_finite(const Numbers& numbers) {
  return std::all_of(numbers.data(), numbers.data() + numbers.size(),
                     [](double x) { return std::isfinite(x); });
}

SharedMap make_map(const Numbers& cells, double resolution, const py::object& origin,
                   std::string name) {
  if (cells.ndim() != 2) throw std::invalid_argument("cells must be an array of height x width");
  const SE2 corner = to_pose(origin, "origin");
  RosMap map{std::move(name),
             static_cast<int>(cells.shape(1)),
             static_cast<int>(cells.shape(0)),
             resolution,
             corner.x,
             corner.y,
             corner.yaw,
             to_cells(cells)};
  auto made = std::make_shared<Map>(std::move(map));
  validate(made->grid);
  return made;
}

template <typename T>
py::array_t<T> grid_view(const Map& map, const T* data, const py::object& self) {
  return view_of(data, {map.map.height, map.map.width}, self);
}

py::array_t<float> distance_field_of(const py::object& self) {
  Map& map = self.cast<Map&>();
  if (!map.distances) {
    const double diagonal = std::hypot(map.map.width, map.map.height) * map.map.resolution;
    map.distances.emplace(map.grid, diagonal);
  }
  return grid_view(map, map.distances->values().data(), self);
}

/// Range from a point in the grid's frame along a beam; infinite beyond `longest`. [m]
float range_along(const localization::OccupancyGrid& grid, const SE2& T_grid_laser, double angle,
                  double longest) {
  const double resolution = grid.frame.resolution;
  const double yaw = T_grid_laser.yaw + angle;
  const double cells = cast_ray(grid, T_grid_laser.translation() / resolution,
                                {std::cos(yaw), std::sin(yaw)}, longest / resolution);
  const double range = cells * resolution;
  return range < longest ? static_cast<float>(range) : std::numeric_limits<float>::infinity();
}

/// Evenly spaced over a turn, from straight ahead.
Numbers all_around(py::ssize_t beams) {
  Numbers angles(beams);
  for (py::ssize_t i = 0; i < beams; ++i) {
    angles.mutable_at(i) = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(beams);
  }
  return angles;
}

void cast_all(const Map& map, const Numbers& poses, const Numbers& angles, double range_max,
              float* ranges) {
  const py::gil_scoped_release no_gil;
  const SE2 T_grid_map = map.grid.frame.T_map_grid.inverse();
  const double* pose = poses.data();
  for (py::ssize_t i = 0; i < poses.size() / 3; ++i, pose += 3) {
    const SE2 T_grid_laser = T_grid_map * SE2{pose[0], pose[1], pose[2]};
    for (py::ssize_t k = 0; k < angles.size(); ++k) {
      *ranges++ = range_along(map.grid, T_grid_laser, angles.data()[k], range_max);
    }
  }
}

py::array_t<float> cast(const Map& map, const Numbers& poses, const std::optional<Numbers>& angles,
                        double range_max) {
  const bool one = poses.ndim() == 1;
  if (poses.ndim() > 2 || poses.ndim() < 1 || poses.shape(poses.ndim() - 1) != 3) {
    throw std::invalid_argument("pose must be (x, y, yaw), or an array of n x 3");
  }
  if (!(range_max > 0.0)) throw std::invalid_argument("range_max must be above 0");
  if (!all_finite(poses) || (angles && !all_finite(*angles))) {
    throw std::invalid_argument("poses and angles must be finite");
  }
  constexpr py::ssize_t kBeams = 360;
  const Numbers beams = angles ? *angles : all_around(kBeams);
  std::vector<py::ssize_t> shape{beams.size()};
  if (!one) shape.insert(shape.begin(), poses.shape(0));
  py::array_t<float> ranges(shape);
  cast_all(map, poses, beams, range_max, ranges.mutable_data());
  return ranges;
}

SharedMap load(const std::filesystem::path& file) {
  return std::make_shared<Map>(testbed::load_ros_map(file));
}

}  // namespace

void bind_map(py::module_& module) {
  py::class_<Map, SharedMap>(module, "Map", "An occupancy grid, as ROS' map_server has it.")
      .def(py::init(&make_map), py::arg("cells"), py::arg("resolution"),
           py::arg("origin") = py::make_tuple(0.0, 0.0, 0.0), py::arg("name") = "map")
      .def_static("load", &load, py::arg("file"), "Reads a map's YAML file and its image.")
      .def(
          "save",
          [](const Map& map, const std::filesystem::path& file) { write_ros_map(map.map, file); },
          py::arg("file"), "Writes the YAML file and <stem>.pgm beside it.")
      .def("cast", &cast, py::arg("pose"), py::arg("angles") = py::none(),
           py::arg("range_max") = 12.0,
           "Ranges that an ideal lidar measures at a pose, or at n poses. [m]")
      .def_property_readonly("distance_field", &distance_field_of,
                             "[m] float32, height x width: from each cell to the nearest wall.")
      .def_property_readonly(
          "cells",
          [](const py::object& self) {
            const Map& map = self.cast<const Map&>();
            return grid_view(map, map.map.cells.data(), self);
          },
          "int8, height x width: -1 unknown, 0 free ... 100 occupied.")
      .def_property_readonly(
          "origin",
          [](const Map& map) {
            return py::make_tuple(map.map.origin_x, map.map.origin_y, map.map.origin_yaw);
          },
          "Pose of the lower left corner of cell (0, 0) in map.")
      .def_property_readonly("name", [](const Map& map) { return map.map.name; })
      .def_property_readonly(
          "width", [](const Map& map) { return map.map.width; }, "[cells]")
      .def_property_readonly(
          "height", [](const Map& map) { return map.map.height; }, "[cells]")
      .def_property_readonly(
          "resolution", [](const Map& map) { return map.map.resolution; }, "[m] Edge of a cell.");
}

}  // namespace castaway::python
