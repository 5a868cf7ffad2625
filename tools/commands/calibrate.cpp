// castaway calibrate: fits models to a recorded log and builds its twin.
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/output/output_folder.hpp"
#include "tools/base/output/say.hpp"
#include "tools/commands/arguments/log_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/twin/calibration_page.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/twin/prediction/calibration_lines.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct CalibrateArguments {
  std::string log;
  std::string map;
  std::string out;
  std::string align = "auto";
  bool force = false;
  bool json = false;
};

void print_group(const CalibrationGroup& group) {
  print_out("{}:\n", group.heading);
  for (const CalibrationLine& line : group.lines) {
    print_out("  {:<28} {:<24} {}\n", line.name, line.value, line.interval);
  }
}

void print_likeness(const Twin& twin) {
  print_out("Twin against log:               median, 90 %: log       twin        Wasserstein\n");
  for (const LikeSamples& s : twin.likeness.samples) {
    print_out("  {:<28} {:>9.4g} {:>9.4g} {:>9.4g} {:>9.4g} {:>10.3g} {}\n", s.name,
              percentile(s.log, 0.5), percentile(s.log, 0.9), percentile(s.twin, 0.5),
              percentile(s.twin, 0.9), wasserstein_distance(s.log, s.twin), s.unit);
  }
}

void print_twin(const Twin& twin) {
  print_out("{}: {}\n", twin.fitted.log.name, alignment_sentence(twin.fitted.log));
  for (const CalibrationGroup& group : calibration_groups(twin)) print_group(group);
  print_likeness(twin);
}

/// How to play the twin, and what to know of it before.
std::string play_sentence(const LogFit& fit, const std::string& folder) {
  const std::string play = fmt::format("castaway run {}/scenario.yaml\n", folder);
  if (fit.odometry) return "Play it: " + play;
  return fmt::format(
      "Its odometry is ideal, not the log's: the robot drove too little to fit it. To play it "
      "nevertheless: {}",
      play);
}

int calibrate(CalibrateArguments arguments) {
  arguments.log = find_shipped(arguments.log);
  const bool is_folder = arguments.map.empty() && std::filesystem::is_directory(arguments.log);
  OutputFolder out({.target = arguments.out,
                    .made_by = "calibrate",
                    .settings = "",
                    .inputs = {arguments.log},
                    .force = arguments.force});
  const RecordedPlace place = is_folder ? load_recorded_place(arguments.log)
                                        : load_recorded_log(arguments.log, arguments.map);
  const Twin twin = build_twin(place, parse_align(arguments.align), out.folder());
  write_file(out.folder() / "calibration.html", render_calibration(twin, place.map));
  out.commit();
  if (arguments.json) {
    print_out("{}\n", json_text(to_json(twin), 1));
  } else {
    print_twin(twin);
    print_out("Plots: {0}/calibration.html\nTwin: {0}\n{1}", arguments.out,
              play_sentence(twin.fitted.fit, arguments.out));
  }
  return kDone;
}

}  // namespace

void add_calibrate_command(Command& app) {
  auto a = std::make_shared<CalibrateArguments>();
  Command command =
      app.add_command("calibrate", "Fit lidar, odometry and people to a log, and build its twin");
  command
      .add_option(
          "log", a->log,
          "CARMEN log (.log, .carmen, .gz), rosbag2, or a folder that holds a log and a map")
      .required();
  command.add_option("--map", a->map, "ROS map (.yaml); of a bag, instead of its own");
  command.add_option("--out", a->out, "Folder of the twin").required();
  add_align_option(command, a->align);
  command.add_flag("--force", a->force, "Write beside files that castaway did not write");
  command.add_flag("--json", a->json, "Print JSON");
  command.footer(
      "Each figure has its 95 % interval. scenario.yaml plays the log's path with what was found; "
      "lidar.yaml, odometry.yaml, people.yaml and differences.yaml are its parts.\n"
      "Example:\n"
      "  castaway calibrate logs/intel.log --map logs/intel.yaml --out twin\n"
      "  castaway run twin/scenario.yaml");
  command.action([a] { return calibrate(*a); });
}

}  // namespace castaway::testbed
