// castaway replay: a recorded log, through the same loop.
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/output/default_folder.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/arguments/recording_arguments.hpp"
#include "tools/commands/arguments/ros2_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/run/report.hpp"
#include "tools/play/execute.hpp"
#include "tools/play/replay/play_replay.hpp"
#include "tools/play/replay/recorded_log.hpp"
#include "tools/play/replay/replay_session.hpp"
#include "tools/play/terminal.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

/// Values from the command line.
struct ReplayArguments {
  std::string log;
  RecordingArguments recording;
  std::string start = "unknown";
  std::int64_t from_scan = 0;
  std::optional<std::int64_t> scans;
  std::string scans_used = "all";
  std::string splice;
  LocalizerArguments localizers;
  std::uint64_t seed = 1;
  std::string out;
  bool force = false;
  bool json = false;
  ReplayOutputs outputs;
  Ros2Arguments ros2;
};

/// Parses "I:J" as two indices of scans.
std::pair<std::int64_t, std::int64_t> parse_splice(const std::string& text) {
  std::int64_t from = 0;
  std::int64_t to = 0;
  char colon = 0;
  char rest = 0;
  std::istringstream stream(text);
  const bool good =
      static_cast<bool>(stream >> from >> colon >> to) && colon == ':' && !(stream >> rest);
  if (!good || text.find('-') != std::string::npos) {
    throw std::invalid_argument("--splice " + text + ": give two scans as I:J, e.g. 120:900");
  }
  return {from, to};
}

/// Index of the first scan played among those that are used, which --splice counts.
std::int64_t first_used_scan(const ReplayArguments& arguments) {
  const std::int64_t first = arguments.from_scan;
  if (arguments.scans_used == "all") return first;
  return arguments.scans_used == "even" ? (first + 1) / 2 : first / 2;
}

/// The jump from scan I to scan J as an event.
YamlNode splice_node(const ReplayArguments& arguments) {
  const auto [from, to] = parse_splice(arguments.splice);
  const std::int64_t first = first_used_scan(arguments);
  if (first > from) {
    throw std::invalid_argument("--splice jumps before --from-scan; begin at an earlier scan");
  }
  return parse_yaml(
      fmt::format("[{{splice: {{after_scans: {}, to_scan: {}}}}}]", from - first + 1, to),
      "--splice");
}

/// Localizers of the command line as an element of a session, those of files included.
YamlNode localizers_node(const std::vector<std::string>& texts) {
  YamlNode list;
  list.kind = YamlNode::Kind::kList;
  for (const std::string& text : texts) {
    YamlNode more;
    if (names_a_file(text)) {
      YamlDocument document = YamlDocument::load(text);
      YamlReader root = document.root();
      const auto listed = root.find("localizers");
      if (!listed || listed->items().empty()) {
        throw std::runtime_error(text + ": lists no localizer; name at least one");
      }
      more = listed->raw();
      document.reject_unknown_keys();
    } else {
      YamlNode root;
      apply_override(root, "localizers=[" + localizer_yaml(text) + "]");
      more = *root.find("localizers");
    }
    list.items.splice(list.items.end(), more.items);
  }
  return list;
}

/// The session that the options ask for.
YamlDocument session_of(const ReplayArguments& a) {
  YamlNode root;
  root.kind = YamlNode::Kind::kMap;
  const auto put = [&](const std::string& key, YamlNode value) {
    root.entries.push_back({key, std::move(value)});
  };
  put("log", write_yaml(a.log));
  put_maps(a.recording, root);
  put("start", write_yaml(a.start));
  put("from_scan", write_yaml(static_cast<std::uint64_t>(a.from_scan)));
  if (a.scans) put("scans", write_yaml(static_cast<std::uint64_t>(*a.scans)));
  put("scans_used", write_yaml(a.scans_used));
  put_topics(a.recording, root);
  put("seed", write_yaml(a.seed));
  if (!a.localizers.texts.empty()) put("localizers", localizers_node(a.localizers.texts));
  if (!a.splice.empty()) put("events", splice_node(a));
  return YamlDocument(std::move(root));
}

/// True for the YAML file of a session, in place of a log.
bool is_session(const std::string& file) {
  return file.ends_with(".yaml") || file.ends_with(".yml");
}

ForeignRules rules_of(const ReplayArguments& arguments) {
  ForeignRules rules{{}, file_programs(arguments.localizers.allow_programs)};
  if (is_session(arguments.log)) rules.folder = std::filesystem::path(arguments.log).parent_path();
  for (const std::string& text : arguments.localizers.texts) {
    if (names_a_file(text)) rules.folder = std::filesystem::path(text).parent_path();
  }
  return rules;
}

/// What a session's file states cannot be stated on the command line, too.
void require_no_other_option(const ReplayArguments& arguments) {
  ReplayArguments plain;
  plain.log = arguments.log;
  plain.localizers.allow_programs = arguments.localizers.allow_programs;
  if (emit_yaml(session_of(arguments).root().copy()) ==
      emit_yaml(session_of(plain).root().copy())) {
    return;
  }
  throw std::invalid_argument(arguments.log +
                              " states what is played; change it there, not by options");
}

ReplaySession session_to_play(const ReplayArguments& arguments) {
  if (!is_session(arguments.log)) return read_session(session_of(arguments), rules_of(arguments));
  require_no_other_option(arguments);
  return read_session(YamlDocument::load(arguments.log), rules_of(arguments));
}

/// What the replay writes and where. Throws if the folder is not free.
OutputRequest output_request(const ReplayArguments& arguments, const ReplaySession& session,
                             const std::string& name) {
  OutputRequest request{arguments.out, "replay", sha256(emit_yaml(session.tree)),
                        inputs_of(session), arguments.force};
  if (is_session(arguments.log)) request.inputs.emplace_back(arguments.log);
  if (arguments.out.empty()) {
    request.target = std::filesystem::path("runs") / name / fmt::format("seed-{}", session.seed);
    request.target = announced_free_folder(request);
  }
  check_output(request);
  return request;
}

int replay_log(ReplayArguments arguments) {
  arguments.log = find_shipped(arguments.log);
  arguments.recording.map = find_shipped(arguments.recording.map);
  const std::chrono::nanoseconds begin = wall_time();
  const ReplaySession session = session_to_play(arguments);
  const RecordedLog log = open_log(session);
  for (const std::string& warning : log.warnings) print_warning(warning);
  const OutputRequest request = output_request(arguments, session, replay_name(log));
  OutputFolder output(request);
  ReplayOutputs outputs = arguments.outputs;
  outputs.bridge = arguments.ros2.bridge();
  outputs.report = write_report;
  Run run = build_replay(session, log, output.folder(), outputs);
  run.loop.load_s = seconds(wall_time() - begin);
  return execute_and_print(run, output, request.target, {arguments.json});
}

}  // namespace

void add_replay_command(Command& app) {
  auto a = std::make_shared<ReplayArguments>();
  Command command = app.add_command("replay", "Localize a recorded log: CARMEN, or a bag of ROS 2");
  command
      .add_option(
          "log", a->log,
          "CARMEN log (.log, .carmen, .gz), a rosbag2 (its folder or an .mcap file), or the "
          ".yaml of a replay: the scenario.yaml of a run, or what a live run saved")
      .required();
  add_recording_options(command, a->recording);
  command.add_option("--start", a->start, "truth or unknown")
      .one_of({"truth", "unknown"})
      .show_default();
  command.add_option("--from-scan", a->from_scan, "Index of the first scan played").not_negative();
  command.add_option("--scans", a->scans, "How many scans are played (default: all)").positive();
  command.add_option("--splice", a->splice,
                     "I:J jumps from scan I to scan J while odometry runs on: a kidnap");
  command
      .add_option("--use", a->scans_used, "Scans handed to the localizers: all, even or odd ones")
      .one_of({"all", "even", "odd"})
      .show_default();
  add_localizer_options(command, a->localizers, "mh_amcl; with --map3d mh_amcl:3d");
  command.add_option("--seed", a->seed, "Root seed").show_default();
  command.add_option("--out", a->out, "Run folder (default: runs/replay-<map>/seed-<n>)");
  command.add_flag("--force", a->force,
                   "Use a folder that holds other files, too; replaces only castaway's own");
  command.add_flag("--json", a->json, "Print summary.json instead of words");
  command.add_flag("--pictures,!--no-pictures", a->outputs.pictures,
                   "Take pictures (default: yes)");
  command
      .add_option("--pictures-every", a->outputs.pictures_every_s,
                  "Also a picture every so many seconds")
      .not_negative();
  add_ros2_options(command, a->ros2);
  add_ros2_pace(command, a->ros2);
  command.footer(
      "TRUEPOS lines, and the truth topic of a bag, are the truth of the metrics; no localizer "
      "sees "
      "them.\n"
      "Examples:\n"
      "  castaway replay intel.log.gz --map intel.yaml --start unknown --localizer mh_amcl "
      "--localizer amcl\n"
      "  castaway replay rosbag2_2026_01_31 --map office.yaml --scan-topic /front/scan\n"
      "  castaway replay rosbag2_2026_01_31 --map3d office.bt");
  command.action([a] { return replay_log(*a); });
}

}  // namespace castaway::testbed
