#include "tools/commands/execute.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "tools/commands/commands.hpp"
#include "tools/commands/progress.hpp"
#include "tools/commands/run_summary.hpp"
#include "tools/formats/file.hpp"
#include "tools/run/errors_sink.hpp"
#include "tools/run/summary_sink.hpp"
#include "tools/run/timing_sink.hpp"
#include "tools/run/trajectory_sink.hpp"

namespace castaway::testbed {
namespace {

std::vector<std::unique_ptr<RunSink>> table_sinks(const RunPlan& plan) {
  std::vector<std::unique_ptr<RunSink>> sinks;
  sinks.push_back(std::make_unique<ErrorsSink>(plan.folder));
  sinks.push_back(std::make_unique<TrajectorySink>(plan.folder, plan.info));
  sinks.push_back(std::make_unique<SummarySink>(plan.folder, plan.info));
  sinks.push_back(std::make_unique<TimingSink>(plan.folder, plan.info));
  return sinks;
}

}  // namespace

int execute(RunPlan& plan, SensorSource& source) {
  std::vector<std::unique_ptr<RunSink>> sinks = table_sinks(plan);
  for (auto& sink : plan.sinks) sinks.push_back(std::move(sink));
  write_file(plan.folder / "scenario.yaml", plan.scenario_yaml);
  try {
    Progress progress(source.duration());
    plan.loop.on_progress = [&progress](Stamp reached) { progress.show(reached); };
    Loop(plan.loop, plan.localizers, sinks).run(source);
  } catch (const std::exception& error) {
    fmt::print(stderr, "castaway: the run failed: {}\n", error.what());
    return kRunFailed;
  }
  fmt::print("{}", plan.json ? read_file(plan.folder / "summary.json") : describe_run(plan.folder));
  return kDone;
}

}  // namespace castaway::testbed
