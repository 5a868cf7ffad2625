// workbench crowds: checks that people never pass a wall.
#include <cstdio>
#include <memory>

#include <unistd.h>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "tests/bench/workbench/commands.hpp"
#include "tests/bench/workbench/crowd_hours.hpp"
#include "tools/base/output/say.hpp"
#include "tools/base/process/cpu_clock.hpp"

namespace castaway::testbed {
namespace {

int watch_and_print(const CrowdHoursConfig& config) {
  const bool progress = isatty(STDERR_FILENO) != 0;
  const std::chrono::nanoseconds begin = thread_cpu_time();
  const CrowdHours seen = watch_crowd(config, [&](int hour) {
    if (progress) fmt::print(stderr, "\r{} h", hour);
  });
  if (progress) fmt::print(stderr, "\r      \r");
  const double cpu_s = localization::seconds(thread_cpu_time() - begin);
  print_out(
      "{:.1f} h of {} people ({:.0f} person-hours), {:.0f} km walked: {} steps through walls, {} "
      "into walls\n"
      "closest two centres {:.2f} m, {} hit by a robot that never yields; {:.0f} s of CPU, {:.0f} "
      "x real time\n",
      seen.hours, config.people.count(), seen.person_hours, seen.walked_km, seen.through,
      seen.inside, seen.closest_pair_m, seen.robot_hits, cpu_s, 3600.0 * seen.hours / cpu_s);
  return seen.through + seen.inside == 0 ? kDone : kRunFailed;
}

}  // namespace

void add_crowds_command(Command& app) {
  auto config = std::make_shared<CrowdHoursConfig>();
  config->people.walking = 20;
  config->people.in_groups = 0.3;
  config->people.behaviour.reset();  // Mixes all behaviours.
  Command command =
      app.add_command("crowds", "Check that people never pass a wall, over hours of simulation");
  command.add_option("--hours", config->hours, "Simulated time [h]").range(1e-4, 1e4);
  command.add_option("--people", config->people.walking, "How many walk").range(1, 200);
  command.add_option("--crowd", config->people.blocked_share, "Share of beams to block")
      .range(0.0, 0.6);
  command.add_option("--world", config->world, "A world's name or path, or a ROS map's .yaml");
  command.add_option("--seed", config->seed, "Root seed of all random streams");
  command.footer(
      "People of all behaviours, a third of them in groups, and a robot that drives its route\n"
      "without yielding. Every step is checked against the world's true shapes at four heights.\n"
      "Exit code 1 if anybody passed or entered a wall. Example:\n"
      "  build/release/workbench crowds --hours 100");
  command.action([config] { return watch_and_print(*config); });
}

}  // namespace castaway::testbed
