#include "python/src/arrays.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace castaway::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The numbers of a sequence or array. @throws std::invalid_argument unless there are `count` and
/// all are finite.
Numbers numbers_of(const py::handle& value, py::ssize_t count, const char* what,
                   const char* expected) {
  Numbers numbers = Numbers::ensure(value);
  if (!numbers) PyErr_Clear();
  if (!numbers || numbers.size() != count) {
    throw std::invalid_argument(std::string(what) + " must be " + expected + ", not " +
                                py::repr(value).cast<std::string>());
  }
  if (!std::all_of(numbers.data(), numbers.data() + count,
                   [](double x) { return std::isfinite(x); })) {
    throw std::invalid_argument(std::string(what) +
                                " is not finite: " + py::repr(value).cast<std::string>());
  }
  return numbers;
}

}  // namespace

py::tuple to_python(const SE2& pose) { return py::make_tuple(pose.x, pose.y, pose.yaw); }

py::object to_python(const std::optional<SE2>& pose) {
  if (!pose) return py::none();
  return to_python(*pose);
}

SE2 to_pose(const py::handle& value, const char* what) {
  const Numbers numbers = numbers_of(value, 3, what, "(x, y, yaw)");
  const double* p = numbers.data();
  return {p[0], p[1], p[2]};
}

std::optional<SE2> to_optional_pose(const py::handle& value, const char* what) {
  if (value.is_none()) return std::nullopt;
  return to_pose(value, what);
}

Eigen::Matrix3d to_covariance(const py::handle& value) {
  if (value.is_none()) return Eigen::Matrix3d::Zero();
  const Numbers numbers = numbers_of(value, 9, "covariance", "3 x 3 numbers");
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
}

std::optional<localization::PoseWithCovariance> to_start(const py::handle& pose,
                                                         const py::handle& covariance) {
  if (pose.is_none()) return std::nullopt;
  return localization::PoseWithCovariance{to_pose(pose, "pose"), to_covariance(covariance)};
}

py::array_t<double> to_array(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  py::array_t<double> array({matrix.rows(), matrix.cols()});
  auto values = array.mutable_unchecked<2>();
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
      values(row, column) = matrix(row, column);
    }
  }
  return array;
}

py::array_t<double> to_array(const std::vector<SE2>& poses) {
  py::array_t<double> array({static_cast<py::ssize_t>(poses.size()), py::ssize_t{3}});
  auto values = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto row = static_cast<py::ssize_t>(i);
    values(row, 0) = poses[i].x;
    values(row, 1) = poses[i].y;
    values(row, 2) = poses[i].yaw;
  }
  return array;
}

}  // namespace castaway::python
