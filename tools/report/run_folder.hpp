/// A run's folder, read back for its report.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "localization/geometry/se2.hpp"
#include "tools/run/event.hpp"

namespace castaway::testbed {

/// A row of errors.csv.
struct ReportRow {
  double stamp_s = 0.0;
  std::optional<localization::SE2> T_map_base_true;
  std::optional<localization::SE2> T_map_base_estimate;
  std::optional<double> position_error_m;
  std::optional<double> yaw_error_rad;
  std::optional<double> quality;
};

/// A row of events.csv.
struct ReportEvent {
  double stamp_s = 0.0;
  EventKind kind = EventKind::kKidnap;
  std::string detail;
  std::string localizer;
  std::optional<double> time_s;
  std::optional<localization::SE2> T_map_from;  ///< Of a kidnap.
  std::optional<localization::SE2> T_map_to;
};

/// One localizer's rows.
struct ReportCurve {
  std::string localizer;
  std::vector<ReportRow> rows;
};

/// A file of snapshots/.
struct ReportPicture {
  std::string name;  ///< "t0032.100-kidnap-1-map.png"
  std::string png;
};

/// All that a report shows.
struct RunFolder {
  nlohmann::ordered_json summary;
  nlohmann::ordered_json timing;  ///< null if there is no timing.json.
  std::vector<ReportCurve> curves;
  std::vector<ReportEvent> events;
  std::vector<ReportPicture> pictures;          ///< By name.
  std::optional<std::string> pictures_missing;  ///< Why there are none, if that is known.
  std::string recording;                        ///< The bytes of recording.gz; empty: none.
};

/// Reads summary.json, errors.csv and events.csv, which must be there, timing.json, the
/// recording and the pictures, which may. Throws std::runtime_error naming the file.
RunFolder load_run_folder(const std::filesystem::path& folder);

}  // namespace castaway::testbed
