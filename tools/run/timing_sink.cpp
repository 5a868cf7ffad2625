#include "tools/run/timing_sink.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "tools/metrics/statistics.hpp"
#include "tools/run/cpu_clock.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

double milliseconds(std::chrono::nanoseconds time) { return 1e3 * seconds(time); }

Json update_figures(std::vector<double> sample) {
  const auto figures = statistics(sample);
  if (!figures) return {{"mean", nullptr}, {"median", nullptr}, {"p99", nullptr}, {"max", nullptr}};
  std::sort(sample.begin(), sample.end());
  return {{"mean", figures->mean},
          {"median", figures->median},
          {"p99", percentile(sample, 0.99)},
          {"max", figures->max}};
}

}  // namespace

TimingSink::TimingSink(std::filesystem::path run_folder, RunInfo info)
    : run_folder_(std::move(run_folder)),
      history_(std::move(info)),
      csv_(run_folder_ / "timing.csv", {"stamp_s", "localizer", "stage", "cpu_ms"}),
      update_ms_(history_.info.localizers.size()),
      stage_ms_(history_.info.localizers.size()) {}

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
      if (time.count() > 0) stage_ms_[i][stage].push_back(milliseconds(time));
    }
    update_ms_[i].push_back(milliseconds(localizer.update_cpu));
  }
  history_.add(record);
}

void TimingSink::finish(Stamp end, const RunTiming& timing) {
  csv_.commit();
  const double simulated = seconds(end - std::min(history_.first_stamp, end));
  Json root;
  root["wall_s"] = timing.wall_s;
  root["load_s"] = timing.load_s;
  root["realtime_factor"] = timing.wall_s > 0.0 ? Json(simulated / timing.wall_s) : Json();
  root["cpu_s"] = {
      {"physics", 0.0}, {"lidar", 0.0}, {"people", 0.0}, {"localizers", 0.0}, {"sinks", 0.0}};
  for (const auto& [stage, cpu] : timing.cpu_s) root["cpu_s"][stage] = cpu;
  root["memory_mb"] = {{"peak", peak_memory_mb()}};
  root["localizers"] = Json::object();
  for (std::size_t i = 0; i < update_ms_.size(); ++i) {
    Json& localizer = root["localizers"][history_.info.localizers[i]];
    localizer["update_ms"] = update_figures(update_ms_[i]);
    localizer["stages_ms"] = Json::object();
    for (const auto& [stage, sample] : stage_ms_[i]) {
      localizer["stages_ms"][stage] = update_figures(sample);
      localizer["stages_ms"][stage]["scans"] = sample.size();
    }
  }
  write_file(run_folder_ / "timing.json", root.dump(2) + "\n");
}

}  // namespace castaway::testbed
