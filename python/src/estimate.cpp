#include "python/src/estimate.hpp"

#include <limits>

#include "python/src/arrays.hpp"

namespace castaway::python {
namespace {

using localization::Alternative;

constexpr double kNotStated = std::numeric_limits<double>::quiet_NaN();

StatedEstimate make_estimate(const py::object& pose, const py::object& covariance,
                             double probability, double quality, bool lost,
                             const py::iterable& hypotheses) {
  StatedEstimate stated;
  stated.estimate.T_map_base = to_pose(pose, "pose");
  stated.estimate.covariance = to_covariance(covariance);
  stated.estimate.probability = probability;
  stated.estimate.quality = quality;
  stated.estimate.lost = lost;
  for (const py::handle& item : hypotheses) {
    const auto [place, share] = item.cast<std::pair<py::object, double>>();
    stated.hypotheses.push_back({to_pose(place, "the pose of a hypothesis"), share});
  }
  static_cast<void>(to_answer(stated, {}));  // Throws where it is made, not where it is used.
  return stated;
}

py::list hypotheses_of(const StatedEstimate& stated) {
  py::list list;
  for (const Alternative& each : stated.hypotheses) {
    list.append(py::make_tuple(to_python(each.T_map_base), each.share));
  }
  return list;
}

py::str text_of(const StatedEstimate& stated) {
  const localization::Estimate& e = stated.estimate;
  return py::str("Estimate(pose=({:.3f}, {:.3f}, {:.3f}), probability={:.3f}, lost={})")
      .format(e.T_map_base.x, e.T_map_base.y, e.T_map_base.yaw, e.probability, e.lost);
}

}  // namespace

testbed::Answer to_answer(const StatedEstimate& stated, localization::Stamp stamp) {
  testbed::Answer answer;
  answer.estimate = stated.estimate;
  answer.estimate->stamp = stamp;
  for (const Alternative& hypothesis : stated.hypotheses) {
    localization::PopulationView view;
    view.id = static_cast<int>(answer.populations.size());
    view.T_map_base = hypothesis.T_map_base;
    view.share = hypothesis.share;
    answer.populations.push_back(std::move(view));
  }
  complete(answer);
  return answer;
}

StatedEstimate to_stated(const localization::Estimate& estimate,
                         const localization::Diagnostics& diagnostics) {
  StatedEstimate stated{estimate, {}};
  stated.estimate.alternatives.clear();  // They follow from the hypotheses.
  for (const localization::PopulationView& view : diagnostics.populations) {
    stated.hypotheses.push_back({view.T_map_base, view.share});
  }
  return stated;
}

void bind_estimate(py::module_& module) {
  py::class_<StatedEstimate>(module, "Estimate", "A localizer's answer to a scan, at its stamp.")
      .def(py::init(&make_estimate), py::arg("pose"), py::kw_only(),
           py::arg("covariance") = py::none(), py::arg("probability") = kNotStated,
           py::arg("quality") = kNotStated, py::arg("lost") = false,
           py::arg("hypotheses") = py::tuple())
      .def_property_readonly(
          "pose", [](const StatedEstimate& s) { return to_python(s.estimate.T_map_base); },
          "(x [m], y [m], yaw [rad]) of base in map.")
      .def_property_readonly(
          "covariance", [](const StatedEstimate& s) { return to_array(s.estimate.covariance); },
          "Of (x, y, yaw), 3 x 3.")
      .def_property_readonly(
          "probability", [](const StatedEstimate& s) { return s.estimate.probability; },
          "In [0, 1] that the pose is right; nan: not stated.")
      .def_property_readonly(
          "quality", [](const StatedEstimate& s) { return s.estimate.quality; },
          "In [0, 1], how well the scan fits the map; nan: not stated.")
      .def_property_readonly(
          "lost", [](const StatedEstimate& s) { return s.estimate.lost; },
          "The alarm: the pose must not be used.")
      .def_property_readonly("hypotheses", &hypotheses_of, "List of (pose, probability).")
      .def("__repr__", &text_of);
}

}  // namespace castaway::python
