#include "tools/report/run_folder.hpp"

#include <algorithm>
#include <stdexcept>

#include "tools/formats/csv.hpp"
#include "tools/formats/file.hpp"

namespace castaway::testbed {
namespace {

using localization::SE2;
using Json = nlohmann::ordered_json;

Json read_json(const std::filesystem::path& path) {
  try {
    return Json::parse(read_file(path));
  } catch (const Json::exception& error) {
    throw std::runtime_error(path.string() + ": broken JSON, run it again: " + error.what());
  }
}

/// Rows of a table, addressed by column names.
class Table {
 public:
  explicit Table(const std::filesystem::path& path) : path_(path), table_(read_csv(path)) {}

  [[nodiscard]] std::size_t size() const { return table_.rows.size(); }
  [[nodiscard]] const std::string& text(std::size_t row, const std::string& column) const {
    return table_.rows[row][table_.column(column)];
  }
  [[nodiscard]] std::optional<double> number(std::size_t row, const std::string& column) const {
    try {
      return csv_number(text(row, column));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path_.string() + ": " + column + ": " + error.what());
    }
  }
  [[nodiscard]] std::optional<SE2> pose(std::size_t row, const std::string& prefix) const {
    const auto x = number(row, prefix + "x_m");
    const auto y = number(row, prefix + "y_m");
    const auto yaw = number(row, prefix + "yaw_rad");
    return x && y && yaw ? std::optional<SE2>({*x, *y, *yaw}) : std::nullopt;
  }

 private:
  std::filesystem::path path_;
  CsvTable table_;
};

ReportCurve& curve_of(std::vector<ReportCurve>& curves, const std::string& localizer) {
  const auto found = std::find_if(curves.begin(), curves.end(), [&](const ReportCurve& curve) {
    return curve.localizer == localizer;
  });
  if (found != curves.end()) return *found;
  return curves.emplace_back(ReportCurve{localizer, {}});
}

std::vector<ReportCurve> read_curves(const Table& table) {
  std::vector<ReportCurve> curves;
  for (std::size_t i = 0; i < table.size(); ++i) {
    curve_of(curves, table.text(i, "localizer"))
        .rows.push_back({table.number(i, "stamp_s").value_or(0.0), table.pose(i, "true_"),
                         table.pose(i, ""), table.number(i, "position_error_m"),
                         table.number(i, "yaw_error_rad"), table.number(i, "quality")});
  }
  return curves;
}

std::vector<ReportEvent> read_events(const Table& table) {
  std::vector<ReportEvent> events;
  for (std::size_t i = 0; i < table.size(); ++i) {
    events.push_back({table.number(i, "stamp_s").value_or(0.0), table.text(i, "kind"),
                      table.text(i, "detail"), table.text(i, "localizer"),
                      table.number(i, "time_s"), table.pose(i, "from_"), table.pose(i, "to_")});
  }
  return events;
}

void read_pictures(const std::filesystem::path& folder, RunFolder& run) {
  if (!std::filesystem::is_directory(folder)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".png") continue;
    run.pictures.push_back({entry.path().filename().string(), read_file(entry.path())});
  }
  std::sort(run.pictures.begin(), run.pictures.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  const auto none = folder / "none.txt";
  if (std::filesystem::exists(none)) run.pictures_missing = read_file(none);
}

}  // namespace

RunFolder load_run_folder(const std::filesystem::path& folder) {
  RunFolder run;
  run.summary = read_json(folder / "summary.json");
  if (!run.summary.contains("localizers") || !run.summary["localizers"].is_object()) {
    throw std::runtime_error((folder / "summary.json").string() +
                             ": has no object 'localizers'; run it again");
  }
  const auto timing = folder / "timing.json";
  if (std::filesystem::exists(timing)) run.timing = read_json(timing);
  run.curves = read_curves(Table(folder / "errors.csv"));
  run.events = read_events(Table(folder / "events.csv"));
  read_pictures(folder / "snapshots", run);
  const auto recording = folder / "recording.gz";
  if (std::filesystem::exists(recording)) run.recording = read_file(recording);
  return run;
}

}  // namespace castaway::testbed
