/// Poses, matrices and arrays of Python.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <Eigen/Core>

#include "castaway/localizer.hpp"

namespace castaway::python {

namespace py = pybind11;

using localization::SE2;

/// (x [m], y [m], yaw [rad]); None for nothing.
py::tuple to_python(const SE2& pose);
py::object to_python(const std::optional<SE2>& pose);

/// Reads three numbers. @throws std::invalid_argument naming `what`.
SE2 to_pose(const py::handle& value, const char* what);
/// Nothing for None.
std::optional<SE2> to_optional_pose(const py::handle& value, const char* what);

/// Reads a covariance of (x, y, yaw): 3 x 3, or 9 numbers row by row; None: zeros.
/// @throws std::invalid_argument
Eigen::Matrix3d to_covariance(const py::handle& value);

/// A start as a localizer takes it; nothing for a pose of None.
std::optional<localization::PoseWithCovariance> to_start(const py::handle& pose,
                                                         const py::handle& covariance);

/// A matrix as a new array.
py::array_t<double> to_array(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// Poses as a new array of n x 3.
py::array_t<double> to_array(const std::vector<SE2>& poses);

/// A view of memory that `owner` keeps alive; Python cannot write to it.
template <typename T>
py::array_t<T> view_of(const T* data, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array_t<T> view(std::move(shape), data, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

}  // namespace castaway::python
