// castaway replay: a recorded log, through the same loop.
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/files/file.hpp"
#include "tools/files/sha256.hpp"
#include "tools/output/default_folder.hpp"
#include "tools/output/file_name.hpp"
#include "tools/play/execute.hpp"
#include "tools/play/run_files.hpp"
#include "tools/play/terminal.hpp"
#include "tools/run/cpu_clock.hpp"
#include "tools/scenario/files/bag_folder.hpp"
#include "tools/scenario/files/ros_map_file.hpp"
#include "tools/scenario/scenario_file.hpp"
#include "tools/sources/bag/bag_reading.hpp"
#include "tools/sources/build_localizers.hpp"
#include "tools/sources/carmen_source.hpp"
#include "tools/sources/map_conversion.hpp"
#include "tools/sources/recorded_source.hpp"

namespace castaway::testbed {
namespace {

/// Values from the command line.
struct ReplayArguments {
  std::string log;
  std::string map;
  std::string start = "unknown";
  std::string scans_used = "all";
  std::string splice;
  CarmenSourceConfig source;
  BagTopicOptions topics;
  LocalizerArguments localizers;
  std::uint64_t seed = 1;
  std::string out;
  bool force = false;
  bool json = false;
  bool pictures = true;
  double pictures_every_s = 0.0;
};

/// The settings that reproduce a replay.
std::string describe(const ReplayArguments& a) {
  std::string text = "# castaway replay\n";
  text += fmt::format(
      "log: {}\nmap: {}\nstart: {}\nfrom_scan: {}\nscans: {}\nscans_used: {}\nsplice: {}\nseed: "
      "{}\n",
      a.log, a.map, a.start, a.source.from_scan,
      a.source.scans ? std::to_string(*a.source.scans) : "~", a.scans_used,
      a.splice.empty() ? "~" : "\"" + a.splice + "\"", a.seed);
  text += "localizers: [";
  for (const std::string& name : a.localizers.texts)
    text += (text.back() == '[' ? "" : ", ") + name;
  return text + "]\n";
}

/// Contents of a log.
struct OpenedLog {
  std::unique_ptr<SensorSource> source;
  RosMap map;
  std::optional<SE2> start;
  std::vector<LidarFacts> lidars = {};  ///< Of a bag.
};

localization::PoseWithCovariance known_start(const ReplayArguments& arguments,
                                             const OpenedLog& log) {
  if (!log.start) {
    throw std::runtime_error(arguments.log +
                             ": holds no truth at the first scan, so there is no true start; use "
                             "--start unknown");
  }
  return {*log.start, Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal()};
}

/// Parses "I:J" as two indices of scans.
Splice parse_splice(const std::string& text) {
  Splice at;
  char colon = 0;
  char rest = 0;
  std::istringstream stream(text);
  const bool good =
      static_cast<bool>(stream >> at.from >> colon >> at.to) && colon == ':' && !(stream >> rest);
  if (!good || text.find('-') != std::string::npos) {
    throw std::invalid_argument("--splice " + text + ": give two scans as I:J, e.g. 120:900");
  }
  return at;
}

/// Opens the CARMEN log, or splices two stretches of it.
std::unique_ptr<SensorSource> carmen_source(const ReplayArguments& arguments) {
  if (arguments.splice.empty()) {
    return std::make_unique<CarmenSource>(arguments.log, arguments.source);
  }
  Splice at = parse_splice(arguments.splice);
  CarmenSourceConfig whole = arguments.source;
  whole.from_scan = 0;
  whole.scans.reset();
  CarmenSource log(arguments.log, whole);
  Frames frames;
  while (auto frame = log.next()) frames.push_back(std::move(*frame));
  at.from_first = static_cast<std::size_t>(arguments.source.from_scan);
  if (at.from_first > at.from) {
    throw std::invalid_argument("--splice jumps before --from-scan; begin at an earlier scan");
  }
  Frames part = splice(frames, at);
  if (arguments.source.scans)
    part = first_scans(part, static_cast<std::size_t>(*arguments.source.scans));
  return std::make_unique<RecordedSource>(std::move(part));
}

OpenedLog open_carmen(const ReplayArguments& arguments) {
  if (!std::filesystem::exists(arguments.log)) {
    throw std::runtime_error(arguments.log +
                             ": cannot be read; check the path and its permissions");
  }
  if (arguments.map.empty()) {
    throw std::invalid_argument("--map is missing: a CARMEN log holds no map");
  }
  OpenedLog log;
  log.map = load_ros_map(arguments.map);
  log.source = carmen_source(arguments);
  log.start = log.source->start_pose();
  return log;
}

/// The map of --map, or the bag's own.
RosMap map_of(const ReplayArguments& arguments, const BagInventory& bag,
              const BagRecording& recording) {
  if (!arguments.map.empty()) return load_ros_map(arguments.map);
  if (!recording.map) {
    throw std::runtime_error(arguments.log + ": holds no OccupancyGrid; name a map by --map");
  }
  RosMap map = *recording.map;
  const auto run = bag.metadata.find("run");
  const bool named = run != bag.metadata.end() && run->second.contains("world");
  map.name = named ? run->second.at("world") : bag.files.front().stem().string();
  return map;
}

OpenedLog open_bag(const ReplayArguments& arguments) {
  if (!arguments.splice.empty() || arguments.source.from_scan != 0 ||
      arguments.scans_used != "all") {
    throw std::invalid_argument("--splice, --from-scan and --use take CARMEN logs, not bags");
  }
  const BagInventory bag = take_inventory(arguments.log, bag_files(arguments.log));
  BagRecording recording = read_bag(bag, choose_topics(bag, arguments.topics));
  for (const std::string& warning : recording.warnings) {
    print_warning(warning);
  }
  OpenedLog log;
  log.map = map_of(arguments, bag, recording);
  if (arguments.source.scans) {
    recording.frames =
        first_scans(recording.frames, static_cast<std::size_t>(*arguments.source.scans));
  }
  log.lidars = lidars_of(recording.frames);
  auto source = std::make_unique<RecordedSource>(std::move(recording.frames));
  log.start = recording.start ? recording.start : source->start_pose();
  log.source = std::move(source);
  return log;
}

/// The files that a replay reads.
std::vector<std::filesystem::path> inputs_of(const ReplayArguments& arguments) {
  std::vector<std::filesystem::path> inputs{arguments.log};
  if (is_bag(arguments.log)) {
    for (const auto& file : bag_files(arguments.log)) inputs.push_back(file);
  }
  if (!arguments.map.empty()) inputs.emplace_back(arguments.map);
  return inputs;
}

/// What the replay writes and where. Throws if the folder is not free.
OutputRequest output_request(const ReplayArguments& arguments, const std::string& scenario) {
  OutputRequest request{arguments.out, "replay", sha256(describe(arguments)), inputs_of(arguments),
                        arguments.force};
  if (arguments.out.empty()) {
    request.target =
        std::filesystem::path("runs") / scenario / fmt::format("seed-{}", arguments.seed);
    request.target = announced_free_folder(request);
  }
  check_output(request);
  return request;
}

RunInfo info_of(const ReplayArguments& arguments, const std::vector<LocalizerSpec>& specs,
                const RosMap& map) {
  RunInfo info;
  info.scenario = "replay-" + file_name_of(map.name);
  info.world = map.name;
  info.robot = "recorded";
  info.seed = arguments.seed;
  info.known_start = arguments.start == "truth";
  info.localizers = names_of(specs);
  return info;
}

RunFiles files_of(const ReplayArguments& arguments, const RosMap& map) {
  RunFiles files;
  if (!arguments.pictures) return files;
  files.pictures = PictureConfig{arguments.pictures_every_s, true, 960, 720};
  files.picture_world.map = map;
  return files;
}

/// Builds the run; its files go into `folder`.
Run build_run(const ReplayArguments& arguments, const std::vector<LocalizerSpec>& specs,
              OpenedLog log, const std::filesystem::path& folder) {
  const RunInfo info = info_of(arguments, specs, log.map);
  Run run;
  if (info.known_start) run.loop.start = known_start(arguments, log);
  run.localizers =
      build_localizers(specs, {log.map, arguments.map, log.lidars, folder}, arguments.seed);
  write_file(folder / "scenario.yaml", describe(arguments));
  RunSinks built =
      build_sinks(folder, info, log.map, log.source->duration(), files_of(arguments, log.map));
  for (const std::string& warning : built.warnings) print_warning(warning);
  run.sinks = std::move(built.sinks);
  run.source = std::move(log.source);
  return run;
}

int replay_log(ReplayArguments arguments) {
  const std::chrono::nanoseconds begin = wall_time();
  if (arguments.localizers.texts.empty()) arguments.localizers.texts = {"mh_amcl"};
  const std::vector<LocalizerSpec> specs = arguments.localizers.specs({});
  using Scans = CarmenSourceConfig::Scans;
  if (arguments.scans_used != "all") {
    arguments.source.selection = arguments.scans_used == "even" ? Scans::kEven : Scans::kOdd;
  }
  OpenedLog log = is_bag(arguments.log) ? open_bag(arguments) : open_carmen(arguments);
  for (const std::string& warning : log.map.warnings) print_warning(warning);
  const OutputRequest request = output_request(arguments, "replay-" + file_name_of(log.map.name));
  OutputFolder output(request);
  Run run = build_run(arguments, specs, std::move(log), output.folder());
  run.loop.load_s = seconds(wall_time() - begin);
  return execute_and_print(run, output, request.target, {arguments.json});
}

}  // namespace

void add_replay_command(Command& app) {
  auto a = std::make_shared<ReplayArguments>();
  Command command = app.add_command("replay", "Localize a recorded log: CARMEN, or a bag of ROS 2");
  command
      .add_option("log", a->log,
                  "CARMEN log (.log, .carmen, .gz), or a rosbag2: its folder or an .mcap file")
      .required();
  command.add_option("--map", a->map, "ROS map (.yaml); of a bag, instead of its own");
  command
      .add_option("--scan-topic", a->topics.scans, "LaserScan topic of a bag; repeat for several")
      .repeatable();
  command.add_option("--odom-topic", a->topics.odometry,
                     "Odometry topic of a bag, or its /tf (default: by type, else /tf)");
  command.add_option("--truth-topic", a->topics.truth,
                     "Topic of the true pose (default: /ground_truth/odom, if there is one)");
  command.add_option("--start", a->start, "truth or unknown")
      .one_of({"truth", "unknown"})
      .show_default();
  command.add_option("--from-scan", a->source.from_scan, "Index of the first scan played")
      .not_negative();
  command.add_option("--scans", a->source.scans, "How many scans are played (default: all)")
      .positive();
  command.add_option("--splice", a->splice,
                     "I:J jumps from scan I to scan J while odometry runs on: a kidnap");
  command
      .add_option("--use", a->scans_used, "Scans handed to the localizers: all, even or odd ones")
      .one_of({"all", "even", "odd"})
      .show_default();
  add_localizer_options(command, a->localizers, "mh_amcl");
  command.add_option("--seed", a->seed, "Root seed").show_default();
  command.add_option("--out", a->out, "Run folder (default: runs/replay-<map>/seed-<n>)");
  command.add_flag("--force", a->force,
                   "Use a folder that holds other files, too; replaces only castaway's own");
  command.add_flag("--json", a->json, "Print summary.json instead of words");
  command.add_flag("--pictures,!--no-pictures", a->pictures, "Take pictures (default: yes)");
  command
      .add_option("--pictures-every", a->pictures_every_s, "Also a picture every so many seconds")
      .not_negative();
  command.footer(
      "TRUEPOS lines, and the truth topic of a bag, are the truth of the metrics; no localizer "
      "sees "
      "them.\n"
      "Examples:\n"
      "  castaway replay intel.log.gz --map intel.yaml --start unknown --localizer mh_amcl "
      "--localizer amcl\n"
      "  castaway replay rosbag2_2026_01_31 --map office.yaml --scan-topic /front/scan");
  command.action([a] { return replay_log(*a); });
}

}  // namespace castaway::testbed
