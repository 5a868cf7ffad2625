/// Reads a run folder for its report.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "localization/geometry/se2.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// A row of errors.csv.
struct ReportRow {
  double stamp_s = 0.0;
  std::optional<localization::SE2> T_map_base_true;
  std::optional<localization::SE2> T_map_base_estimate;
  std::optional<double> position_error_m;
  std::optional<double> yaw_error_rad;
  std::optional<double> quality;
  std::optional<double> z_true{};      ///< [m] In runs on several floors.
  std::optional<double> z_estimate{};  ///< [m]
};

/// A row of events.csv.
struct ReportEvent {
  double stamp_s = 0.0;
  EventData what;
  std::string localizer;
  std::optional<double> time_s;
  std::optional<localization::SE2> T_map_from;  ///< For a kidnap: pose before it.
  std::optional<localization::SE2> T_map_to;
  std::optional<double> from_z{};  ///< [m] In runs on several floors.
  std::optional<double> to_z{};    ///< [m]
};

/// Rows of one localizer.
struct ReportCurve {
  std::string localizer;
  std::vector<ReportRow> rows;
};

/// A file of snapshots/.
struct ReportPicture {
  std::string name;  ///< "t0032.100-kidnap-1-map.png"
  std::string png;
};

/// Content of a report.
struct RunFolder {
  nlohmann::ordered_json summary;
  nlohmann::ordered_json timing;  ///< null if there is no timing.json.
  std::vector<ReportCurve> curves;
  std::vector<ReportEvent> events;
  std::vector<ReportPicture> pictures;          ///< Sorted by name.
  std::optional<std::string> pictures_missing;  ///< Why there are none, if known.
  std::string recording;                        ///< Bytes of recording.gz; empty if it does not
                                                ///< exist.
  std::string settings;  ///< Text of scenario.yaml; empty if it does not exist.
};

/// Reads summary.json, errors.csv and events.csv, which must exist, and scenario.yaml, timing.json,
/// the recording and the pictures, which are optional. Throws std::runtime_error naming the file.
RunFolder load_run_folder(const std::filesystem::path& folder);

/// Collects rows. Once there are more than `most`, adjacent pairs are merged into the row with the
/// larger position error, so that peaks are kept. Later rows are merged to the same density.
class ThinnedCurve {
 public:
  explicit ThinnedCurve(std::size_t most) : most_(most) {}

  void add(const ReportRow& row);
  /// The rows kept, in their original order.
  [[nodiscard]] std::vector<ReportRow> take();

 private:
  void halve();

  std::size_t most_;
  std::size_t stride_ = 1;  ///< Number of input rows per kept row.
  std::size_t open_ = 0;    ///< Number of input rows in the last kept row so far.
  std::vector<ReportRow> rows_;
};

}  // namespace castaway::testbed
