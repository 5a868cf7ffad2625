// castaway calibrate: fits models to a recorded log and builds its twin.
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "tools/commands/commands.hpp"
#include "tools/output/output_folder.hpp"
#include "tools/twin/twin_folder.hpp"

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

AlignBy parse_align(const std::string& text) {
  if (text == "truth") return AlignBy::kTruth;
  return text == "mh_amcl" ? AlignBy::kMhAmcl : AlignBy::kAuto;
}

/// A line of the table; `scale` converts the figure to the unit shown.
void print_figure(const char* name, const Figure& figure, const char* unit, double scale = 1.0) {
  fmt::print("  {:<28} {:>10.4g} {:<12} {:.4g} to {:.4g}\n", name, scale * figure.value, unit,
             scale * figure.interval.low, scale * figure.interval.high);
}

void print_odometry(const LogFit& fit) {
  if (!fit.odometry) {
    fmt::print("Odometry: not fitted, the robot drove less than 100 m\n");
    return;
  }
  fmt::print("Odometry, over {:.0f} m:\n", fit.odometry->way_m);
  print_figure("distance, true over measured", fit.odometry->scale, "% more", 100.0);
  print_figure("turn, true over measured", fit.odometry->yaw_scale, "% more", 100.0);
  print_figure("curvature", fit.odometry->curvature, "deg/m", 57.29577951308232);
  print_figure("random walk along", fit.odometry->drift_along, "m/sqrt(m)");
  print_figure("random walk of the yaw", fit.odometry->drift_yaw_deg, "deg/sqrt(m)");
}

void print_lidar(const LogFit& fit) {
  fmt::print("Lidar, {:.2f} scans a second:\n", fit.stamps.rate_hz);
  if (fit.clock) {
    print_figure("clock ahead of odometry", fit.clock->offset_s, "ms", 1000.0);
  } else {
    fmt::print("  clock: not fitted, odometry comes too seldom or turns too evenly\n");
  }
  if (fit.noise) {
    print_figure("noise at range 0", fit.noise->sigma_m, "mm", 1000.0);
    print_figure("noise per metre", fit.noise->sigma_relative, "mm/m", 1000.0);
    print_figure("range behind the map's walls", fit.noise->bias_m, "mm", 1000.0);
    fmt::print("  {:<28} {:>10.4g} mm\n", "resolution", 1000.0 * fit.noise->resolution_m);
  } else {
    fmt::print("  noise: not fitted, too few beams on straight walls\n");
  }
  if (fit.loss) {
    print_figure("lost on walls", fit.loss->lost, "% of beams", 100.0);
  } else {
    fmt::print("  losses: not fitted, too few beams on straight walls\n");
  }
}

void print_building(const Twin& twin) {
  if (!twin.fitted.fit.building) return;
  const BuildingFit& fit = *twin.fitted.fit.building;
  fmt::print("Building against map, {:.0f} m^2:\n", fit.free_area_m2);
  print_figure("beams on what moves", fit.moving_share, "%", 100.0);
  print_figure("beams on new objects", fit.standing_share, "%", 100.0);
  print_figure("beams through walls", fit.through_share, "%", 100.0);
  fmt::print("  {:<28} {:>10} new, {} walls gone\n", "objects", fit.standing.size(),
             fit.gone.size());
  print_figure("people", twin.people, "");
}

void print_likeness(const Twin& twin) {
  fmt::print("Twin against log:               median, 90 %: log       twin        Wasserstein\n");
  for (const LikeSamples& s : twin.likeness) {
    fmt::print("  {:<28} {:>9.4g} {:>9.4g} {:>9.4g} {:>9.4g} {:>10.3g} {}\n", s.name,
               percentile(s.log, 0.5), percentile(s.log, 0.9), percentile(s.twin, 0.5),
               percentile(s.twin, 0.9), wasserstein_distance(s.log, s.twin), s.unit);
  }
}

void print_twin(const Twin& twin) {
  const AlignedLog& log = twin.fitted.log;
  fmt::print("{}: {} scans aligned by {}, {} left out; {:.0f} % of the end points on walls\n",
             log.name, log.scans.size(), log.by_truth ? "reference poses" : "mh_amcl", log.left_out,
             100.0 * log.on_walls);
  print_odometry(twin.fitted.fit);
  print_lidar(twin.fitted.fit);
  print_building(twin);
  print_likeness(twin);
}

int calibrate(const CalibrateArguments& arguments) {
  const bool is_folder = arguments.map.empty() && std::filesystem::is_directory(arguments.log);
  OutputFolder out({.target = arguments.out,
                    .made_by = "calibrate",
                    .settings = "",
                    .inputs = {arguments.log},
                    .force = arguments.force});
  const RecordedPlace place = is_folder ? load_recorded_place(arguments.log)
                                        : load_recorded_log(arguments.log, arguments.map);
  const Twin twin = build_twin(place, parse_align(arguments.align), out.folder());
  out.commit();
  if (arguments.json) {
    fmt::print("{}\n", to_json(twin).dump(1));
  } else {
    print_twin(twin);
    fmt::print("Twin: {0}\nPlay it: castaway run {0}/scenario.yaml\n", arguments.out);
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
  command
      .add_option("--align", a->align,
                  "Poses of the scans: truth (reference poses of the log), mh_amcl, or auto (truth "
                  "where most scans have it)")
      .one_of({"auto", "truth", "mh_amcl"})
      .show_default();
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
