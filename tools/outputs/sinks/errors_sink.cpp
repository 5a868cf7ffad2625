#include "tools/outputs/sinks/errors_sink.hpp"

#include <algorithm>
#include <cmath>

namespace castaway::testbed {
namespace {

using localization::Estimate;
using localization::PopulationView;

void write_errors(CsvWriter& csv, const ScanRecord& record,
                  const std::optional<Estimate>& estimate) {
  if (record.true_pose && estimate) {
    csv.number(position_error(record, *estimate));
    csv.number(localization::yaw_distance(record.true_pose->T_map_base, estimate->T_map_base));
  } else {
    csv.empty().empty();
  }
}

std::optional<double> if_stated(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

void write_belief(CsvWriter& csv, const std::optional<Estimate>& estimate) {
  if (!estimate) {
    csv.empty().empty().empty().empty().empty();
    return;
  }
  const Eigen::Matrix3d& covariance = estimate->covariance;
  csv.number(if_stated(estimate->quality));
  csv.number(std::sqrt(0.5 * (covariance(0, 0) + covariance(1, 1))));
  csv.number(std::sqrt(covariance(2, 2)));
  csv.number(if_stated(estimate->probability)).count(estimate->lost ? 1 : 0);
}

void write_populations(CsvWriter& csv, const std::vector<PopulationView>& populations) {
  std::size_t particles = 0;
  for (const PopulationView& population : populations) particles += population.particles.size();
  csv.count(static_cast<std::int64_t>(populations.size()));
  csv.count(static_cast<std::int64_t>(particles));
  const auto selected = std::find_if(populations.begin(), populations.end(),
                                     [](const PopulationView& view) { return view.selected; });
  if (selected == populations.end()) {
    csv.empty();
  } else {
    csv.count(selected->id);
  }
}

void write_heights(CsvWriter& csv, const ScanRecord& record,
                   const std::optional<Estimate>& estimate) {
  csv.number(record.has_heights() ? std::optional(record.true_pose->z()) : std::nullopt);
  const bool stated = estimate && estimate->footing;
  csv.number(stated ? std::optional(estimate->footing->z) : std::nullopt);
  csv.number(stated ? std::optional<double>(estimate->footing->level) : std::nullopt);
}

std::vector<std::string> columns_of(const RunInfo& info) {
  std::vector<std::string> columns{"stamp_s",          "localizer",     "true_x_m", "true_y_m",
                                   "true_yaw_rad",     "x_m",           "y_m",      "yaw_rad",
                                   "position_error_m", "yaw_error_rad", "quality",  "sigma_m",
                                   "sigma_yaw_rad",    "probability",   "lost",     "populations",
                                   "particles",        "selected"};
  if (info.heights) columns.insert(columns.end(), {"true_z_m", "z_m", "level"});
  return columns;
}

}  // namespace

ErrorsSink::ErrorsSink(const std::filesystem::path& run_folder, const RunInfo& info)
    : csv_(run_folder / "errors.csv", columns_of(info)), heights_(info.heights) {}

void ErrorsSink::on_scan(const ScanRecord& record) {
  for (const LocalizerRecord& localizer : record.localizers) {
    csv_.number(seconds(record.stamp)).text(localizer.name);
    csv_.pose(T_map_base_of(record.true_pose));
    csv_.pose(localizer.estimate ? std::optional<SE2>(localizer.estimate->T_map_base)
                                 : std::nullopt);
    write_errors(csv_, record, localizer.estimate);
    write_belief(csv_, localizer.estimate);
    write_populations(csv_, localizer.diagnostics.populations);
    if (heights_) write_heights(csv_, record, localizer.estimate);
    csv_.end_row();
  }
}

}  // namespace castaway::testbed
