#include "tools/play/execute.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "tools/files/file.hpp"
#include "tools/files/sha256.hpp"
#include "tools/output/exit_code.hpp"
#include "tools/output/output_folder.hpp"
#include "tools/play/progress.hpp"
#include "tools/play/run_summary.hpp"
#include "tools/report/report.hpp"
#include "tools/sinks/errors_sink.hpp"
#include "tools/sinks/people_sink.hpp"
#include "tools/sinks/points_sink.hpp"
#include "tools/sinks/recording_sink.hpp"
#include "tools/sinks/scans_sink.hpp"
#include "tools/sinks/summary_sink.hpp"
#include "tools/sinks/tables_csv_sink.hpp"
#include "tools/sinks/tables_hdf5_sink.hpp"
#include "tools/sinks/timing_sink.hpp"
#include "tools/sinks/trajectory_sink.hpp"

namespace castaway::testbed {
namespace {

std::vector<std::unique_ptr<RunSink>> table_sinks(const RunPlan& plan,
                                                  const std::filesystem::path& folder) {
  std::vector<std::unique_ptr<RunSink>> sinks;
  sinks.push_back(std::make_unique<ErrorsSink>(folder));
  sinks.push_back(std::make_unique<TrajectorySink>(folder, plan.info));
  sinks.push_back(std::make_unique<SummarySink>(folder, plan.info));
  if (plan.timing) sinks.push_back(std::make_unique<TimingSink>(folder, plan.info));
  if (plan.people_every_s > 0.0) {
    sinks.push_back(std::make_unique<PeopleSink>(folder, plan.people_every_s));
  }
  if (plan.label_name) sinks.push_back(std::make_unique<ScansSink>(folder, plan.label_name));
  if (plan.tables_csv) {
    sinks.push_back(std::make_unique<TablesCsvSink>(folder, plan.info.localizers, plan.labels));
  }
  if (plan.tables_hdf5) {
    sinks.push_back(std::make_unique<TablesHdf5Sink>(folder, plan.info.localizers, plan.labels));
  }
  if (plan.points_every_s > 0.0) {
    sinks.push_back(std::make_unique<PointsSink>(folder, plan.points_every_s));
  }
  return sinks;
}

void add_recording(const RunPlan& plan, const std::filesystem::path& folder, Stamp duration,
                   std::vector<std::unique_ptr<RunSink>>& sinks) {
  if (!plan.report || !plan.player) return;
  RecordingConfig config;
  config.robot_radius_m = plan.picture_world.robot_radius;
  config.scan_every_s = scan_period(seconds(duration));
  config.detail_every_s = detail_period(seconds(duration));
  sinks.push_back(std::make_unique<RecordingSink>(folder, plan.info, plan.map, config));
}

void add_pictures(RunPlan& plan, const std::filesystem::path& folder,
                  std::vector<std::unique_ptr<RunSink>>& sinks) {
  auto sink = std::make_unique<PictureSink>(folder, plan.info, std::move(plan.picture_world),
                                            *plan.pictures);
  if (sink->missing() && !plan.quiet) {
    fmt::print(stderr, "castaway: warning: no pictures: {}\n", *sink->missing());
  }
  sinks.push_back(std::move(sink));
}

using Sinks = std::vector<std::unique_ptr<RunSink>>;

/// All that listens to the run, and the first of its files.
Sinks begin_run(RunPlan& plan, const std::filesystem::path& folder, Stamp duration) {
  Sinks sinks = table_sinks(plan, folder);
  write_file(folder / "scenario.yaml", plan.scenario_yaml);
  for (auto& sink : export_sinks(folder, plan.info, plan.map, plan.exports)) {
    sinks.push_back(std::move(sink));
  }
  for (const SinkMaker& make : plan.more_sinks) sinks.push_back(make(folder, plan));
  add_recording(plan, folder, duration, sinks);
  if (plan.camera) {
    sinks.push_back(
        std::make_unique<CameraSink>(folder, *plan.camera, plan.picture_world, plan.instances));
  }
  if (plan.film) sinks.push_back(std::make_unique<FilmSink>(*plan.film, plan.picture_world));
  if (plan.pictures) add_pictures(plan, folder, sinks);
  return sinks;
}

void carry_out(RunPlan& plan, SensorSource& source, Sinks sinks, OutputFolder& output) {
  {
    Progress progress(source.duration(), plan.quiet);
    plan.loop.on_progress = [&progress](Stamp reached) {
      throw_if_interrupted();
      progress.show(reached);
    };
    Loop(plan.loop, plan.localizers, sinks).run(source);
  }
  if (plan.report) write_report(output.folder(), plan.map);
  sinks.clear();
  throw_if_interrupted();
  output.commit();
}

}  // namespace

OutputRequest output_request(const RunPlan& plan) {
  return {plan.folder, plan.made_by, sha256(plan.scenario_yaml),
          plan.inputs, plan.force,   plan.keep_list};
}

void execute_run(RunPlan& plan, SensorSource& source) {
  OutputFolder output(output_request(plan));
  carry_out(plan, source, begin_run(plan, output.folder(), source.duration()), output);
}

int execute(RunPlan& plan, SensorSource& source) {
  OutputFolder output(output_request(plan));
  Sinks sinks = begin_run(plan, output.folder(), source.duration());
  try {
    carry_out(plan, source, std::move(sinks), output);
  } catch (const std::exception& error) {
    throw_if_interrupted();  // Whatever failed, failed because of it: ffmpeg is interrupted, too.
    fmt::print(stderr, "castaway: the run failed: {}\n", error.what());
    return kRunFailed;
  }
  if (plan.silent || plan.quiet) return kDone;
  fmt::print("{}", plan.json ? read_file(plan.folder / "summary.json") : describe_run(plan.folder));
  if (plan.film && !plan.json) fmt::print("Film:       {}\n", plan.film->format.file.string());
  return kDone;
}

}  // namespace castaway::testbed
