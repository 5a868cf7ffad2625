#include "tools/outputs/sinks/timing_sink.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/base/process/git_commit.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

double milliseconds(std::chrono::nanoseconds time) { return 1e3 * seconds(time); }

/// When, where and at which commit of the user's repository, if there is one.
Json made_json() {
  Json made = {{"date", utc_date()}, {"machine", machine_text()}};
  std::error_code none;
  const std::string commit = git_commit(std::filesystem::current_path(none));
  if (!commit.empty()) made["commit"] = commit;
  return made;
}

Json update_figures(const ThinnedSample& sample) {
  const auto figures = statistics(sample.values());
  if (!figures) return {{"mean", nullptr}, {"median", nullptr}, {"p99", nullptr}, {"max", nullptr}};
  std::vector<double> sorted = sample.values();
  std::sort(sorted.begin(), sorted.end());
  return {{"mean", sample.mean()},
          {"median", figures->median},
          {"p99", percentile(sorted, 0.99)},
          {"max", sample.max()}};
}

}  // namespace

TimingSink::TimingSink(std::filesystem::path run_folder, RunInfo info)
    : run_folder_(std::move(run_folder)),
      info_(std::move(info)),
      csv_(run_folder_ / "timing.csv", {"stamp_s", "localizer", "stage", "cpu_ms"}),
      update_ms_(info_.localizers.size()),
      stage_ms_(info_.localizers.size()) {}

void TimingSink::on_scan(const ScanRecord& record) {
  for (std::size_t i = 0; i < record.localizers.size(); ++i) {
    const LocalizerRecord& localizer = record.localizers[i];
    const auto row = [&](const std::string& stage, std::chrono::nanoseconds time) {
      csv_.number(seconds(record.stamp)).text(localizer.name).text(stage);
      csv_.number(milliseconds(time)).end_row();
    };
    row("update", localizer.update_cpu);
    for (const auto& [stage, time] : localizer.stage_cpu) {
      row(stage, time);
      if (time.count() > 0) stage_ms_[i][stage].add(milliseconds(time));
    }
    update_ms_[i].add(milliseconds(localizer.update_cpu));
  }
  note(record.stamp);
}

void TimingSink::finish(Stamp end, const RunTiming& timing) {
  csv_.commit();
  const double simulated = seconds(end - std::min(first_stamp_, end));
  Json root;
  root["wall_s"] = timing.wall_s;
  root["load_s"] = timing.load_s;
  root["realtime_factor"] = timing.wall_s > 0.0 ? Json(simulated / timing.wall_s) : Json();
  root["cpu_s"] = {
      {"physics", 0.0}, {"lidar", 0.0}, {"people", 0.0}, {"localizers", 0.0}, {"sinks", 0.0}};
  for (const auto& [stage, cpu] : timing.cpu_s) root["cpu_s"][stage] = cpu;
  root["memory_mb"] = {{"peak", peak_memory_mb()}};
  root["made"] = made_json();
  root["localizers"] = Json::object();
  for (std::size_t i = 0; i < update_ms_.size(); ++i) {
    Json& localizer = root["localizers"][info_.localizers[i]];
    localizer["update_ms"] = update_figures(update_ms_[i]);
    localizer["stages_ms"] = Json::object();
    for (const auto& [stage, sample] : stage_ms_[i]) {
      localizer["stages_ms"][stage] = update_figures(sample);
      localizer["stages_ms"][stage]["scans"] = sample.count();
    }
  }
  for (const auto& [name, use] : timing.outside) {
    if (!use.counts.empty()) continue;  // A node of ROS 2: its process is not ours.
    root["localizers"][name]["outside"] = {{"cpu_s", localization::seconds(use.cpu)},
                                           {"peak_memory_mb", use.peak_memory_mb}};
  }
  write_file(run_folder_ / "timing.json", json_text(root, 2) + "\n");
}

}  // namespace castaway::testbed
