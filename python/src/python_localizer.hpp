/// A localizer of Python in a run of C++.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <pybind11/pybind11.h>

#include "castaway/localizer.hpp"
#include "tools/build/foreign/answer.hpp"
#include "tools/run/foreign_config.hpp"

namespace castaway::python {

/// An object of Python that C++ holds, and lets go of with the GIL.
using HeldObject = std::shared_ptr<pybind11::object>;

/// Called with the GIL.
HeldObject hold(pybind11::object object);

/// Calls `initialize`, `on_odometry` and `on_scan` of an object. Its methods are called without the
/// GIL. Exceptions of Python pass through. @throws std::invalid_argument for an estimate that
/// cannot be, pybind11::type_error for an answer that is none.
class PythonLocalizer final : public localization::Localizer {
 public:
  /// Calls `setup` of the object. With the GIL.
  PythonLocalizer(HeldObject localizer, const testbed::Greeting& greeting);

  void initialize(const std::optional<localization::PoseWithCovariance>& start) override;
  void on_odometry(const localization::Odometry& odometry) override;
  void on_scan(const localization::LaserScan& scan) override;
  [[nodiscard]] std::optional<localization::Estimate> estimate() const override {
    return answer_.estimate;
  }
  [[nodiscard]] localization::Diagnostics diagnostics() const override;

 private:
  HeldObject localizer_;
  std::string name_;
  std::optional<localization::Odometry> before_;
  testbed::Answer answer_;
};

/// The configuration of a localizer of Python: an object that has those methods, or something that
/// makes one when it is called, such as its class. Call it with the GIL.
testbed::OwnConfig python_config(pybind11::object localizer_or_factory);

void bind_setup(pybind11::module_& module);

}  // namespace castaway::python
