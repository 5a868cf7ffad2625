// castaway bench crowds: checks that people never pass a wall.
#include <cstdio>
#include <memory>

#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "localization/geometry/stamp.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/batch/bench/crowd_hours.hpp"
#include "tools/commands/bench/bench.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct CrowdArguments {
  CrowdHoursConfig config;
  bool json = false;
};

int bench_crowds(CrowdArguments arguments) {
  arguments.config.people.behaviour.reset();  // Mixes all behaviours.
  const bool progress = isatty(STDERR_FILENO) != 0;
  const std::chrono::nanoseconds begin = thread_cpu_time();
  const CrowdHours seen = watch_crowd(arguments.config, [&](int hour) {
    if (progress) fmt::print(stderr, "\r{} h", hour);
  });
  if (progress) fmt::print(stderr, "\r      \r");
  const double cpu_s = localization::seconds(thread_cpu_time() - begin);
  if (arguments.json) {
    const nlohmann::ordered_json json{
        {"hours", seen.hours},           {"person_hours", seen.person_hours},
        {"through_walls", seen.through}, {"inside_walls", seen.inside},
        {"walked_km", seen.walked_km},   {"closest_pair_m", seen.closest_pair_m},
        {"robot_hits", seen.robot_hits}, {"cpu_s", cpu_s}};
    print_out("{}\n", json_text(json, 1));
    return kDone;
  }
  print_out(
      "{:.1f} h of {} people ({:.0f} person-hours), {:.0f} km walked: {} steps through walls, {} "
      "into walls\n"
      "closest two centres {:.2f} m, {} hit by a robot that never yields; {:.0f} s of CPU, {:.0f} "
      "x real time\n",
      seen.hours, arguments.config.people.count(), seen.person_hours, seen.walked_km, seen.through,
      seen.inside, seen.closest_pair_m, seen.robot_hits, cpu_s, 3600.0 * seen.hours / cpu_s);
  return seen.through + seen.inside == 0 ? kDone : kRunFailed;
}

}  // namespace

void add_bench_crowds(Command& bench) {
  auto arguments = std::make_shared<CrowdArguments>();
  arguments->config.people.walking = 20;
  arguments->config.people.in_groups = 0.3;
  Command command =
      bench.add_command("crowds", "Check that people never pass a wall, over hours of simulation");
  CrowdHoursConfig& config = arguments->config;
  command.add_option("--hours", config.hours, "Simulated time [h]").range(1e-4, 1e4);
  command.add_option("--people", config.people.walking, "How many walk").range(1, 200);
  command.add_option("--crowd", config.people.blocked_share, "Share of beams to block")
      .range(0.0, 0.6);
  command.add_option("--world", config.world, "A world's name or path, or a ROS map's .yaml");
  command.add_option("--seed", config.seed, "Root seed of all random streams");
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "People of all behaviours, a third of them in groups, and a robot that drives its route\n"
      "without yielding. Every step is checked against the world's true shapes at four heights.\n"
      "Exit code 1 if anybody passed or entered a wall. Example:\n"
      "  castaway bench crowds --hours 100");
  command.action([arguments] { return bench_crowds(*arguments); });
}

}  // namespace castaway::testbed
