#include "tools/pages/run/run_folder.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "tools/base/files/file.hpp"
#include "tools/base/formats/csv.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

/// The more informative row: a row without an error (the localizer had no output), else the larger
/// error.
const ReportRow& more_informative(const ReportRow& a, const ReportRow& b) {
  if (!a.position_error_m || !b.position_error_m) return a.position_error_m ? b : a;
  return *b.position_error_m > *a.position_error_m ? b : a;
}

using localization::SE2;
constexpr std::size_t kMostRows = 40000;  // Per localizer; over an hour at 10 Hz.

/// Cells of a row, addressed by column name.
class Row {
 public:
  Row(const std::filesystem::path& path, const std::map<std::string, std::size_t>& columns,
      const std::vector<std::string>& cells)
      : path_(path), columns_(columns), cells_(cells) {}

  [[nodiscard]] const std::string& text(const std::string& column) const {
    const auto found = columns_.find(column);
    if (found != columns_.end()) return cells_[found->second];
    throw std::runtime_error(path_.string() + ": the table has no column '" + column + "'");
  }
  [[nodiscard]] std::optional<double> number(const std::string& column) const {
    try {
      return csv_number(text(column));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path_.string() + ": " + column + ": " + error.what());
    }
  }
  /// Nothing in a table without that column.
  [[nodiscard]] std::optional<double> number_if(const std::string& column) const {
    return columns_.contains(column) ? number(column) : std::nullopt;
  }
  [[nodiscard]] EventData event(const std::string& kind, const std::string& detail) const {
    if (const auto what = event_named(text(kind), text(detail))) return *what;
    throw std::runtime_error(path_.string() + ": " + kind + ": no kind of event is called '" +
                             text(kind) + "'");
  }
  [[nodiscard]] std::optional<SE2> pose(const std::string& prefix) const {
    const auto x = number(prefix + "x_m");
    const auto y = number(prefix + "y_m");
    const auto yaw = number(prefix + "yaw_rad");
    return x && y && yaw ? std::optional<SE2>({*x, *y, *yaw}) : std::nullopt;
  }

 private:
  const std::filesystem::path& path_;
  const std::map<std::string, std::size_t>& columns_;
  const std::vector<std::string>& cells_;
};

/// Calls `visit(row)` for every row of a table.
template <typename Visit>
void for_each_row(const std::filesystem::path& path, Visit visit) {
  CsvReader reader(path);
  std::map<std::string, std::size_t> columns;
  for (std::size_t i = 0; i < reader.header().size(); ++i) columns.emplace(reader.header()[i], i);
  while (const auto cells = reader.next()) visit(Row(path, columns, *cells));
}

std::vector<ReportCurve> read_curves(const std::filesystem::path& path) {
  std::vector<std::pair<std::string, ThinnedCurve>> curves;
  for_each_row(path, [&](const Row& row) {
    const std::string& name = row.text("localizer");
    auto found = std::find_if(curves.begin(), curves.end(),
                              [&](const auto& curve) { return curve.first == name; });
    if (found == curves.end()) {
      found = curves.emplace(curves.end(), name, ThinnedCurve(kMostRows));
    }
    found->second.add({row.number("stamp_s").value_or(0.0), row.pose("true_"), row.pose(""),
                       row.number("position_error_m"), row.number("yaw_error_rad"),
                       row.number("quality"), row.number_if("true_z_m"), row.number_if("z_m")});
  });
  std::vector<ReportCurve> result;
  for (auto& [name, curve] : curves) result.push_back({name, curve.take()});
  return result;
}

std::vector<ReportEvent> read_events(const std::filesystem::path& path) {
  std::vector<ReportEvent> events;
  for_each_row(path, [&](const Row& row) {
    events.push_back({row.number("stamp_s").value_or(0.0), row.event("kind", "detail"),
                      row.text("localizer"), row.number("time_s"), row.pose("from_"),
                      row.pose("to_"), row.number_if("from_z_m"), row.number_if("to_z_m")});
  });
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

void ThinnedCurve::add(const ReportRow& row) {
  if (open_ == 0 || open_ == stride_) {
    if (rows_.size() >= most_) halve();
    rows_.push_back(row);
    open_ = 1;
    return;
  }
  rows_.back() = ReportRow(more_informative(rows_.back(), row));
  ++open_;
}

void ThinnedCurve::halve() {
  std::vector<ReportRow> half;
  half.reserve(most_);
  for (std::size_t i = 0; i + 1 < rows_.size(); i += 2) {
    half.push_back(more_informative(rows_[i], rows_[i + 1]));
  }
  if (rows_.size() % 2 != 0) half.push_back(rows_.back());
  rows_ = std::move(half);
  stride_ *= 2;
}

std::vector<ReportRow> ThinnedCurve::take() { return std::move(rows_); }

RunFolder load_run_folder(const std::filesystem::path& folder) {
  RunFolder run;
  run.summary = read_json(folder / "summary.json");
  if (!run.summary.contains("localizers") || !run.summary["localizers"].is_object()) {
    throw std::runtime_error((folder / "summary.json").string() +
                             ": has no object 'localizers'; run it again");
  }
  const auto timing = folder / "timing.json";
  if (std::filesystem::exists(timing)) run.timing = read_json(timing);
  run.curves = read_curves(folder / "errors.csv");
  run.events = read_events(folder / "events.csv");
  read_pictures(folder / "snapshots", run);
  const auto recording = folder / "recording.gz";
  if (std::filesystem::exists(recording)) run.recording = read_file(recording);
  const auto settings = folder / "scenario.yaml";
  if (std::filesystem::exists(settings)) run.settings = read_file(settings);
  return run;
}

}  // namespace castaway::testbed
