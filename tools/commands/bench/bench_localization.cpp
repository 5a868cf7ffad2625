// castaway bench localization: speed of the parts of the localizer.
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/bench/localization_bench.hpp"
#include "tools/commands/bench/bench.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct LocalizationArguments {
  bool quick = false;
  bool json = false;
};

/// Formats a time in a suitable unit.
std::string duration(double s) {
  if (s < 0.9995e-3) return fmt::format("{:.1f} us", 1e6 * s);
  return s < 0.9995 ? fmt::format("{:.2f} ms", 1e3 * s) : fmt::format("{:.2f} s", s);
}

void print_steps(const std::vector<StepTime>& steps) {
  print_out("{:<22} {:>10} {:>12} {:>8}   {}\n", "5 x 200 particles", "CPU", "plain", "ratio",
            "180 beams");
  for (const StepTime& time : steps) {
    print_out("{:<22} {:>10} {:>12} {:>7.1f}x   {:.3g} M {} a second\n", time.step,
              duration(time.time_s), duration(time.plain_s), time.plain_s / time.time_s,
              1e-6 * time.items / time.time_s, time.item);
  }
}

void print_match_header() {
  print_out("\n{:<30} {:>16} {:>12} {:>12} {:>8}\n", "match", "branch and bound", "exhaustive",
            "plain", "ratio");
}

void print_match(const MatchTime& time) {
  const std::string what = fmt::format("{:.0f} x {:.0f} m, {:.2f} m, {} x {}", time.width,
                                       time.height, time.cell, time.yaws, time.points);
  const auto ratio = [&] { return fmt::format("{:.0f}x", *time.plain_s / time.branch_s); };
  print_out("{:<30} {:>16} {:>12} {:>12} {:>8}\n", what, duration(time.branch_s),
            duration(time.exhaustive_s), time.plain_s ? duration(*time.plain_s) : "-",
            time.plain_s ? ratio() : "-");
  std::fflush(stdout);
}

using Json = nlohmann::ordered_json;

Json to_json(const StepTime& time) {
  return {{"step", time.step},   {"cpu_s", time.time_s}, {"plain_s", time.plain_s},
          {"items", time.items}, {"item", time.item},    {"ratio", time.plain_s / time.time_s}};
}

Json to_json(const MatchTime& time) {
  return {{"width_m", time.width},
          {"height_m", time.height},
          {"cell_m", time.cell},
          {"yaws", time.yaws},
          {"points", time.points},
          {"branch_and_bound_s", time.branch_s},
          {"exhaustive_s", time.exhaustive_s},
          {"plain_s", time.plain_s ? Json(*time.plain_s) : Json()}};
}

int bench_localization(const LocalizationArguments& arguments) {
  BenchEffort effort;
  if (arguments.quick) effort = {1e-4, 0.01, 5};
  const bool words = !arguments.json;
  const std::vector<StepTime> steps = time_steps(effort);
  Json json{{"steps", Json::array()}, {"match", Json::array()}};
  for (const StepTime& time : steps) json["steps"].push_back(to_json(time));
  if (words) print_steps(steps);
  if (words) print_match_header();
  const auto take = [&](const MatchTime& time) {
    json["match"].push_back(to_json(time));
    if (words) print_match(time);
  };
  take(time_match(10.0, 10.0, effort));
  take(time_match(20.0, 15.0, effort));
  if (!arguments.quick) {
    take(time_match(40.0, 30.0, effort));
    take(time_match(80.0, 60.0, effort));
    take(time_fine_match(40.0, 30.0, effort));
  }
  if (arguments.json) print_out("{}\n", json_text(json, 1));
  return kDone;
}

}  // namespace

void add_bench_localization(Command& bench) {
  auto arguments = std::make_shared<LocalizationArguments>();
  Command command = bench.add_command(
      "localization", "Speed of the parts of the localizer, beside a plain reference");
  command.add_flag("--quick", arguments->quick, "Rough figures and small maps only");
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "CPU time of one core, median of many repetitions. The reference does the same work "
      "straight\n"
      "from the formulas, in double, with sine and cosine at every beam.\n"
      "Example:\n"
      "  castaway bench localization");
  command.action([arguments] { return bench_localization(*arguments); });
}

}  // namespace castaway::testbed
