/// The outcome of a cell, as a line of a campaign's rows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/batch/jobs/rows_file.hpp"
#include "tools/run/frame.hpp"
#include "tools/run/metrics/metric_paths.hpp"

namespace castaway::testbed {

/// How a cell ended.
enum class CellOutcome : std::uint8_t {
  kDone,
  kVoid,    ///< Its run carries no information about localizers.
  kFailed,  ///< It ended early, or a localizer did.
};

/// "done", "void", "failed"
std::string to_string(CellOutcome state);

/// A kidnap, and how one localizer took it.
struct CellKidnap {
  std::string localizer;
  std::string kind;
  double at_s = 0.0;            ///< [s] When the robot was put down.
  std::optional<SE2> T_map_to;  ///< Where it was put down.
  bool scored = false;          ///< False: recovery could not be told.
  bool recovered = false;
  std::optional<double> time_s;  ///< [s] To recovery; nothing if there was none.
};

/// What is kept of a cell.
struct CellRow {
  int index = 0;
  std::string cell;  ///< `CampaignCell::name`
  std::uint64_t seed = 1;
  std::vector<std::pair<std::string, std::string>> values;
  CellOutcome state = CellOutcome::kDone;
  std::string reason;   ///< Of a failure, or why the run is void; one line.
  MetricTable metrics;  ///< Without clocks.
  std::vector<CellKidnap> kidnaps;
  double cpu_s = 0.0;  ///< [s] Differs in every repetition, as what follows.
  double wall_s = 0.0;
  double memory_mb = 0.0;  ///< Peak of the process so far.
};

/// The number that a value of `CellRow::values` is; nothing if it is none.
std::optional<double> number_of(const std::string& value);

/// One line of JSON, without a line feed; its last field is a check sum over the others.
std::string row_text(const CellRow& row);
/// The inverse. Throws std::runtime_error if the line is none, or was changed since.
CellRow parse_row(const std::string& line);

/// Where the rows of a campaign are.
class CellRows : public RowIndex {
 public:
  using RowIndex::RowIndex;
  /// Reads the row of a cell that has one.
  [[nodiscard]] CellRow row(int cell) { return parse_row(line(cell)); }
};

}  // namespace castaway::testbed
