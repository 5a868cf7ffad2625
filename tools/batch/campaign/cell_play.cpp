#include "tools/batch/campaign/cell_play.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "tools/base/files/file_error.hpp"
#include "tools/base/formats/csv.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/any_error.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/output_folder.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/play/play.hpp"
#include "tools/run/event_names.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string one_line(std::string text) {
  for (char& c : text) c = c == '\n' ? ' ' : c;
  return text;
}

/// A kidnap of events.csv.
struct PutDown {
  double at_s = 0.0;
  SE2 T_map_base;
};

bool is_kidnap(const std::string& kind) {
  const auto event = event_named(kind, "");
  return event && std::holds_alternative<KidnapEvent>(*event);
}

std::vector<PutDown> read_put_downs(const fs::path& events) {
  const CsvTable table = read_csv(events);
  const std::size_t kind = table.column("kind");
  const std::size_t stamp = table.column("stamp_s");
  const std::size_t to = table.column("to_x_m");
  std::vector<PutDown> found;
  for (const std::vector<std::string>& row : table.rows) {
    const auto x = csv_number(row[to]);
    const auto y = csv_number(row[to + 1]);
    const auto yaw = csv_number(row[to + 2]);
    if (!is_kidnap(row[kind]) || !x || !y || !yaw) continue;
    found.push_back({csv_number(row[stamp]).value_or(0.0), {*x, *y, *yaw}});
  }
  return found;
}

std::optional<SE2> pose_at(const std::vector<PutDown>& put_downs, double at_s) {
  constexpr double kSame = 1e-3;  // [s]
  for (const PutDown& each : put_downs) {
    if (std::abs(each.at_s - at_s) < kSame) return each.T_map_base;
  }
  return std::nullopt;
}

std::vector<CellKidnap> cell_kidnaps(const Json& summary, const std::vector<PutDown>& put_downs) {
  std::vector<CellKidnap> kidnaps;
  for (const auto& [name, figures] : summary.at("localizers").items()) {
    for (const Json& each : figures.at("recovery").at("each")) {
      CellKidnap kidnap;
      kidnap.localizer = name;
      kidnap.kind = each.at("kind").get<std::string>();
      kidnap.at_s = each.at("at_s").get<double>();
      kidnap.T_map_to = pose_at(put_downs, kidnap.at_s);
      kidnap.scored = each.at("scored").get<bool>();
      kidnap.recovered = each.at("recovered").get<bool>();
      if (kidnap.recovered) kidnap.time_s = each.at("time_s").get<double>();
      kidnaps.push_back(std::move(kidnap));
    }
  }
  return kidnaps;
}

void read_outcome(const fs::path& run, CellRow& row) {
  const Json summary = read_json(run / "summary.json");
  row.metrics = metric_table(summary);
  row.kidnaps = cell_kidnaps(summary, read_put_downs(run / "events.csv"));
  if (const auto sentence = void_sentence(summary)) {
    row.state = CellOutcome::kVoid;
    row.reason = *sentence;
  }
}

bool has_failed(const CellRow& row) {
  return row.state != CellOutcome::kDone ||
         std::any_of(row.kidnaps.begin(), row.kidnaps.end(),
                     [](const CellKidnap& each) { return each.scored && !each.recovered; });
}

constexpr const char* kMadeByCampaign = "campaign";

/// Keeps what is asked for of a draft. What castaway did not write in `kept` stays.
void keep(KeepOfCell what, const CellRow& row, const fs::path& draft, const fs::path& kept) {
  require_no_link(kept.parent_path(), kept.filename());
  const bool whole =
      what == KeepOfCell::kFolder || (what == KeepOfCell::kFailures && has_failed(row));
  if (whole) return replace_output(draft, kept);
  if (what != KeepOfCell::kErrors) return remove_output(kept);  // Of an earlier attempt.
  OutputFolder output({kept, kMadeByCampaign, {}, {}, true});
  for (const char* name : {"errors.csv", "events.csv"}) {
    fs::rename(draft / name, output.folder() / name);
  }
  output.commit();
}

CellRow begun_row(const CampaignCell& cell) {
  CellRow row;
  row.index = cell.index;
  row.cell = cell.name;
  row.seed = cell.seed;
  row.values = cell.values;
  return row;
}

std::string localizers_text(const CampaignCell& cell) {
  const YamlNode root = parse_yaml(cell.loaded.effective, "scenario");
  const YamlNode* localizers = root.find("localizers");
  return localizers == nullptr ? "" : emit_yaml(*localizers);
}

/// The localizers that were left out on the way.
std::string failures_of(const std::vector<LostLocalizer>& lost) {
  std::string text;
  for (const LostLocalizer& each : lost) text += (text.empty() ? "" : "; ") + describe(each);
  return text;
}

}  // namespace

CellRow play_cell(const CampaignSpec& spec, const CampaignCell& cell, const fs::path& draft,
                  const fs::path& kept, PartsOfCells& parts) {
  const std::chrono::nanoseconds begin = wall_time();
  const std::chrono::nanoseconds cpu_begin = thread_cpu_time();
  CellRow row = begun_row(cell);
  PlayOptions options;
  options.base = spec.base;
  options.out = draft;
  options.quiet = true;
  options.timing = spec.keep == KeepOfCell::kFolder;
  options.worlds = &parts.worlds;
  options.report = parts.report;
  options.models = {&parts.models, localizers_text(cell)};
  try {
    fs::remove_all(draft);
    const std::string lost = failures_of(play_to_the_end(cell.loaded, options));
    read_outcome(draft, row);
    if (!lost.empty()) {
      row.state = CellOutcome::kFailed;
      row.reason = one_line(lost);
    }
    keep(spec.keep, row, draft, kept);
    fs::remove_all(draft);
  } catch (const FileError&) {
    throw;
  } catch (const fs::filesystem_error& error) {
    throw FileError(error.what());
  } catch (...) {
    row = failed_row(cell, current_error_text());
  }
  row.cpu_s = seconds(thread_cpu_time() - cpu_begin);
  row.wall_s = seconds(wall_time() - begin);
  row.memory_mb = peak_memory_mb();
  return row;
}

CellRow failed_row(const CampaignCell& cell, const std::string& reason) {
  CellRow row = begun_row(cell);
  row.state = CellOutcome::kFailed;
  row.reason = one_line(reason);
  return row;
}

}  // namespace castaway::testbed
