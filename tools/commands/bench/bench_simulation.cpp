// castaway bench simulation: CPU time of a simulated second.
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/bench/simulation_bench.hpp"
#include "tools/commands/bench/bench.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Arguments of the command.
struct SimulationArguments {
  double duration_s = 60.0;
  bool quick = false;
  bool json = false;
};

std::vector<SimulationCostSpec> specs(const SimulationArguments& arguments) {
  const double s = arguments.duration_s;
  if (arguments.quick)
    return {{0, 360, 0, s}, {20, 360, 0, s}, {0, 360, 60, s}, {20, 360, 0, s, true}};
  std::vector<SimulationCostSpec> all;
  for (const int people : {0, 5, 20, 50, 100, 200}) all.push_back({people, 360, 0, s});
  for (const int people : {0, 20, 200}) all.push_back({people, 360, 0, s, true});
  for (const int beams : {90, 720, 1440}) all.push_back({20, beams, 0, s});
  for (const int obstacles : {60, 250, 1000, 4000}) all.push_back({20, 360, obstacles, s});
  return all;
}

void print_cost(const SimulationCost& cost) {
  const auto per_s = [&](const char* stage) {
    const auto found = cost.cpu_s.find(stage);
    return found == cost.cpu_s.end() ? 0.0 : 1e3 * found->second / cost.spec.duration_s;
  };
  std::string where =
      cost.spec.obstacles == 0 ? "lab" : fmt::format("hall, {} boxes", cost.spec.obstacles);
  if (cost.spec.kinematic) where += ", kinematic";
  print_out("{:<18} {:>7} {:>7} {:>10.0f} x {:>11.2f} {:>8.2f} {:>8.2f} {:>8.2f}\n", where,
            cost.spec.people, cost.spec.beams, cost.realtime_factor, per_s("physics"),
            per_s("lidar"), per_s("people"), per_s("drive"));
  std::fflush(stdout);
}

void print_casts(const CastSpeed& speed) {
  print_out("{:>6} boxes {:>5} people   {:>8.2f} M rays/s   {:>8.3f} M by a loop   {:>7.1f}x\n",
            speed.boxes, speed.people, 1e-6 * speed.rays_per_s, 1e-6 * speed.plain_rays_per_s,
            speed.rays_per_s / speed.plain_rays_per_s);
  std::fflush(stdout);
}

Json to_json(const SimulationCost& cost) {
  Json cpu = Json::object();
  for (const auto& [stage, time] : cost.cpu_s) cpu[stage] = time;
  return {{"people", cost.spec.people},
          {"beams", cost.spec.beams},
          {"obstacles", cost.spec.obstacles},
          {"kinematic", cost.spec.kinematic},
          {"duration_s", cost.spec.duration_s},
          {"realtime_factor", cost.realtime_factor},
          {"cpu_s", cpu}};
}

Json to_json(const CastSpeed& speed) {
  return {{"boxes", speed.boxes},
          {"people", speed.people},
          {"rays_per_s", speed.rays_per_s},
          {"plain_rays_per_s", speed.plain_rays_per_s}};
}

int bench_simulation(const SimulationArguments& arguments) {
  const bool words = !arguments.json;
  Json json{{"runs", Json::array()}, {"casts", Json::array()}};
  if (words) {
    print_out("{:<18} {:>7} {:>7} {:>12} {:>11} {:>8} {:>8} {:>8}\n", "CPU ms a second", "people",
              "beams", "real time", "physics", "lidar", "people", "drive");
  }
  for (const SimulationCostSpec& spec : specs(arguments)) {
    const SimulationCost cost = time_simulation(spec);
    json["runs"].push_back(to_json(cost));
    if (words) print_cost(cost);
  }
  if (words) print_out("\n");
  const double seconds = arguments.quick ? 0.05 : 2.0;
  for (const auto& [boxes, people] : {std::pair{60, 0}, {60, 20}, {60, 200}, {920, 20}}) {
    const CastSpeed speed = time_casts(boxes, people, seconds);
    json["casts"].push_back(to_json(speed));
    if (words) print_casts(speed);
  }
  if (arguments.json) print_out("{}\n", json_text(json, 1));
  return kDone;
}

}  // namespace

void add_bench_simulation(Command& bench) {
  auto arguments = std::make_shared<SimulationArguments>();
  Command command = bench.add_command(
      "simulation", "CPU time of a simulated second over people, beams and obstacles");
  command.add_option("--duration", arguments->duration_s, "Simulated time of each run [s]")
      .range(0.1, 1e6);
  command.add_flag("--quick", arguments->quick, "Four runs and rough figures");
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "CPU time of one core; physics at 240 Hz (kinematic: steps of 10 ms), a lidar of 10 Hz, no "
      "localizer. The last lines: "
      "beams\ncast in a hall of 20 m x 20 m, by the scene's tree and by a loop over all shapes.\n"
      "Example:\n"
      "  castaway bench simulation");
  command.action([arguments] { return bench_simulation(*arguments); });
}

}  // namespace castaway::testbed
