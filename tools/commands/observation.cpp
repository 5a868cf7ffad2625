// castaway observation: a picture of what a robot's lidar sees on the map of a localizer.
#include <memory>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "tools/base/output/own_file.hpp"
#include "tools/base/output/say.hpp"
#include "tools/commands/arguments/robot_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/play/observation/observation_picture.hpp"
#include "tools/play/observation/observed_scenario.hpp"
#include "tools/play/terminal.hpp"

namespace castaway::testbed {
namespace {

// The figure that is made without arguments.
constexpr const char* kPlanarExample = "lab/moved";
constexpr const char* kSlopeExample = "hillside/drive";
constexpr const char* kExampleRobot = "mule";
constexpr double kExampleTime = 63.0;  // [s]

/// Arguments of the command.
struct ObservationArguments {
  std::vector<std::string> scenarios;
  std::string robot;
  RobotArguments robot_options;
  std::vector<std::string> sets;
  std::optional<double> time_s;
  double reach = 3.0;
  PanelSize size;
  std::string out = "observation.png";
};

std::vector<std::string> overrides_of(const ObservationArguments& arguments) {
  std::vector<std::string> overrides = robot_overrides(arguments.robot, arguments.robot_options);
  overrides.insert(overrides.end(), arguments.sets.begin(), arguments.sets.end());
  return overrides;
}

void require_png(const std::filesystem::path& file) {
  if (file.extension() == ".png") return;
  throw std::invalid_argument("--out is a PNG file: end its name in .png, not " + file.string());
}

Observation observe_named(const std::string& name, const ObservationArguments& arguments) {
  const ObservedScenario scenario = observed_scenario(name, overrides_of(arguments));
  Observation seen =
      observe(scenario.loaded.scenario, scenario.base, arguments.time_s.value_or(0.0));
  for (const std::string& warning : seen.warnings) print_warning(warning);
  return seen;
}

double mean_likelihood(const Observation& seen) {
  const double sum = std::accumulate(seen.beams.begin(), seen.beams.end(), 0.0,
                                     [](double total, const ObservedBeam& beam) {
                                       return total + static_cast<double>(beam.likelihood);
                                     });
  return sum / static_cast<double>(seen.beams.size());
}

void fill_in_example(ObservationArguments& arguments) {
  arguments.scenarios = {kPlanarExample, kSlopeExample};
  if (arguments.robot.empty()) arguments.robot = kExampleRobot;
  if (!arguments.time_s) arguments.time_s = kExampleTime;
}

int make_observation(ObservationArguments arguments) {
  require_png(arguments.out);
  require_own_file(arguments.out);
  if (arguments.scenarios.empty()) fill_in_example(arguments);
  std::vector<Observation> observations;
  for (const std::string& name : arguments.scenarios) {
    observations.push_back(observe_named(name, arguments));
  }
  write_own_file(arguments.out, sim::encode_png(observation_picture(observations, arguments.reach,
                                                                    arguments.size)));
  for (std::size_t i = 0; i < observations.size(); ++i) {
    print_out("{}: {} beams on a {} map, mean likelihood {:.2f}\n", arguments.scenarios[i],
              observations[i].beams.size(), observations[i].volume ? "3-D" : "planar",
              mean_likelihood(observations[i]));
  }
  print_out("{}\n", arguments.out);
  return kDone;
}

}  // namespace

void add_observation_command(Command& app) {
  auto a = std::make_shared<ObservationArguments>();
  Command command = app.add_command(
      "observation", "Picture of a scan on the map, coloured by the observation model");
  command.add_option("scenario", a->scenarios,
                     "Scenarios, as of `castaway run`, or worlds: a panel each, from the top "
                     "(default: lab/moved hillside/drive --robot mule --time 63)");
  command.add_option("--robot", a->robot, "A robot's name, a .urdf or a .xacro");
  add_robot_options(command, a->robot_options);
  command.add_option("--set", a->sets, "Override a key of all scenarios: key=value").repeatable();
  command
      .add_option("--time", a->time_s,
                  "Time of the scan in the run [s] (default: 0, the robot stands at its start)")
      .range(0.0, 1e7);
  command
      .add_option("--reach", a->reach, "How far the map is shown left and right of the robot [m]")
      .show_default()
      .range(0.5, 500.0);
  command.add_option("--width", a->size.width, "Of a panel [px]").show_default().range(64, 4096);
  command.add_option("--height", a->size.height, "Of a panel [px]").show_default().range(64, 4096);
  command.add_option("--out", a->out, "PNG file to write").show_default();
  command.footer(
      "Examples:\n  castaway observation\n"
      "  castaway observation hall hillside --out observation.png");
  command.action([a] { return make_observation(*a); });
}

}  // namespace castaway::testbed
