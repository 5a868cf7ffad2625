#include "python/src/native_localizer.hpp"

#include <memory>
#include <string>

#include <pybind11/stl.h>

#include "python/src/arrays.hpp"
#include "python/src/estimate.hpp"
#include "python/src/map.hpp"
#include "python/src/one_thread.hpp"
#include "python/src/scan.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::python {
namespace {

using localization::PopulationView;
using testbed::LocalizerSpec;

/// Reads `{mh_amcl: {...}}`. @throws std::runtime_error naming the key and the nearest known one.
LocalizerSpec read_spec(const std::string& yaml, const std::string& who) {
  testbed::YamlDocument document = testbed::YamlDocument::parse("localizers: [" + yaml + "]", who);
  testbed::YamlReader root = document.root();
  const std::vector<LocalizerSpec> specs = read_localizers(root, "localizers");
  document.reject_unknown_keys();
  return specs.front();
}

/// A localizer with the interface of `castaway.Localizer`.
class NativeLocalizer {
 public:
  NativeLocalizer(const std::string& yaml, const Map& map, std::uint64_t seed,
                  const std::string& who) {
    const LocalizerSpec spec = read_spec(yaml, who);
    const py::gil_scoped_release no_gil;
    localizer_ = testbed::build_localizer(spec, {spec.name, seed, map.map, {}, {}}).localizer;
  }

  void initialize(const py::object& pose, const py::object& covariance) {
    const OneThread::Use use(thread_);
    localizer_->initialize(to_start(pose, covariance));
  }
  void on_odometry(std::int64_t stamp_ns, const py::object& pose) {
    const OneThread::Use use(thread_);
    localizer_->on_odometry({localization::Stamp(stamp_ns), to_pose(pose, "pose")});
  }
  /// Nothing if there is no estimate at the scan's stamp.
  std::optional<StatedEstimate> on_scan(const SharedScan& scan) {
    const OneThread::Use use(thread_);
    const py::gil_scoped_release no_gil;
    localizer_->on_scan(*scan);
    const auto estimate = localizer_->estimate();
    if (!estimate || estimate->stamp != scan->stamp) return std::nullopt;
    return to_stated(*estimate, localizer_->diagnostics());
  }
  [[nodiscard]] std::vector<PopulationView> populations() {
    const OneThread::Use use(thread_);
    return localizer_->diagnostics().populations;
  }

 private:
  OneThread thread_;
  std::unique_ptr<localization::Localizer> localizer_;
};

void bind_population(py::module_& module) {
  py::class_<PopulationView>(module, "Population", "One population of particles.")
      .def_readonly("id", &PopulationView::id, "Unique over the life of the localizer.")
      .def_property_readonly(
          "pose", [](const PopulationView& view) { return to_python(view.T_map_base); },
          "Mean (x [m], y [m], yaw [rad]) of base in map.")
      .def_readonly("quality", &PopulationView::quality, "In [0, 1].")
      .def_readonly("probability", &PopulationView::share, "In [0, 1].")
      .def_readonly("selected", &PopulationView::selected, "Its mean is the estimate.")
      .def_property_readonly(
          "particles", [](const PopulationView& view) { return to_array(view.particles); },
          "Poses of base in map, n x 3.");
}

}  // namespace

void bind_native_localizer(py::module_& module) {
  bind_population(module);
  py::class_<NativeLocalizer>(module, "NativeLocalizer", "One of castaway's own localizers.")
      .def(py::init<const std::string&, const Map&, std::uint64_t, const std::string&>(),
           py::arg("yaml"), py::arg("map"), py::arg("seed"), py::arg("who"))
      .def("initialize", &NativeLocalizer::initialize, py::arg("pose"), py::arg("covariance"))
      .def("on_odometry", &NativeLocalizer::on_odometry, py::arg("stamp_ns"), py::arg("pose"))
      .def("on_scan", &NativeLocalizer::on_scan, py::arg("scan").none(false))
      .def_property_readonly("populations", &NativeLocalizer::populations);
  module.def("localizer_seed", &testbed::localizer_seed, py::arg("run_seed"), py::arg("name"),
             "Root of the random numbers of a localizer in a run.");
}

}  // namespace castaway::python
