// castaway calibrate: fits models to a recorded log and builds its twin.
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "tools/commands/commands.hpp"
#include "tools/files/file.hpp"
#include "tools/output/output_folder.hpp"
#include "tools/twin/twin_run.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {
namespace {

struct CalibrateArguments {
  std::string folder;
  std::string out;
  std::string align = "auto";
  LogFitConfig config;
  bool json = false;
};

int calibrate(CalibrateArguments arguments) {
  if (arguments.align == "truth") arguments.config.align = AlignBy::kTruth;
  if (arguments.align == "mh_amcl") arguments.config.align = AlignBy::kMhAmcl;
  arguments.config.track = kTwinTrack;
  const RecordedPlace place = load_recorded_place(arguments.folder);
  const FittedLog fitted = fit_log(place, arguments.config);
  OutputFolder out({.target = arguments.out, .made_by = "calibrate", .settings = ""});
  const std::filesystem::path& folder = out.folder();
  write_ros_map(place.map, folder / "map.yaml");
  write_file(folder / "path.tum", path_text(fitted));
  const Figure people = fit_people(folder, fitted);
  write_file(folder / "scenario.yaml",
             twin_scenario(fitted, static_cast<int>(std::lround(people.value))));
  nlohmann::ordered_json json = to_json(fitted);
  json["people"] = to_json(people);
  write_file(folder / "calibration.json", json.dump(1) + "\n");
  out.commit();
  if (arguments.json) fmt::print("{}\n", json.dump(1));
  return kDone;
}

}  // namespace

void add_calibrate_command(Command& app) {
  auto a = std::make_shared<CalibrateArguments>();
  Command command = app.add_command("calibrate", "Fit models of lidar and odometry to a log");
  command.add_option("folder", a->folder, "Folder that holds a log and a map").required();
  command.add_option("--out", a->out, "Folder of the twin").required();
  command.add_option("--align", a->align, "auto, truth or mh_amcl").show_default();
  command.add_flag("--json", a->json, "Print JSON");
  command.footer("Example:\n  castaway calibrate logs/intel --out twin");
  command.action([a] { return calibrate(*a); });
}

}  // namespace castaway::testbed
