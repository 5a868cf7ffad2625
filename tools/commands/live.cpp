// castaway live: a run in the browser, with hands.
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/base/output/exit_code.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/output/say.hpp"
#include "tools/base/process/fork_child.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/arguments/recording_arguments.hpp"
#include "tools/commands/arguments/ros2_arguments.hpp"
#include "tools/commands/arguments/scenario_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/live/lines/bridge_process.hpp"
#include "tools/live/live_page.hpp"
#include "tools/live/live_player.hpp"
#include "tools/live/served_nodes.hpp"
#include "tools/live/server/live_server.hpp"
#include "tools/live/server/live_token.hpp"
#include "tools/pages/run/report.hpp"
#include "tools/play/bridge.hpp"
#include "tools/play/play.hpp"
#include "tools/play/replay/play_replay.hpp"
#include "tools/play/terminal.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

struct LiveArguments {
  ScenarioArguments played;  ///< Its scenario may be a log, too, or the folder of a finished run.
  RecordingArguments recording;
  std::string start = "unknown";
  std::string address = "127.0.0.1";
  int port = 8080;
  bool play = false;
  Ros2Arguments ros2;
};

/// True for a recorded log: a file, or the folder of a bag.
bool is_log(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) {
    return !std::filesystem::exists(path / "summary.json") &&
           std::filesystem::exists(path / "metadata.yaml");
  }
  const std::string name = path.filename().string();
  return std::ranges::any_of(std::array{".log", ".gz", ".carmen", ".mcap", ".db3"},
                             [&](const char* ending) { return name.ends_with(ending); });
}

/// True for the file of a session, which names a log.
bool is_session(const std::filesystem::path& path) {
  const bool is_yaml = path.extension() == ".yaml" || path.extension() == ".yml";
  if (!is_yaml || !std::filesystem::is_regular_file(path)) return false;
  return parse_yaml(read_file(path, kLargestSettings), path.string()).find("log") != nullptr;
}

/// Options of recorded logs are refused for everything else. `why` follows the option's name.
void require_no_recording_option(const LiveArguments& arguments, const std::string& why) {
  const std::string option = arguments.recording.first_given();
  if (!option.empty()) throw std::invalid_argument(option + why);
}

/// What a log is named by, and what a simulated run has in its place.
std::string why_no_log(const LiveArguments& arguments) {
  std::string why = " is of a log: name one (.log, .log.gz, .mcap, .db3, a bag's folder)";
  if (arguments.recording.first_given() != "--map3d") return why;
  return why + "; of a simulated world, --localizer mh_amcl:3d makes its own";
}

/// Options of simulated runs are refused for logs and finished runs.
void require_no_simulation_option(const ScenarioArguments& arguments) {
  const std::pair<const char*, bool> options[] = {
      {"--name", !arguments.name.empty()},
      {"--world", !arguments.world.empty()},
      {"--robot", !arguments.robot.empty()},
      {"--arg", !arguments.robot_options.assignments.empty()},
      {"--search-path", !arguments.robot_options.search_paths.empty()}};
  for (const auto& [option, given] : options) {
    if (given) {
      throw std::invalid_argument(std::string(option) + ": is for simulated runs, and " +
                                  arguments.scenario + " is recorded; leave it away");
    }
  }
}

/// The overrides of a log: localizers and --set.
std::vector<std::string> overrides_of_log(const ScenarioArguments& arguments) {
  std::vector<std::string> overrides = localizer_override(arguments.localizers);
  overrides.insert(overrides.end(), arguments.sets.begin(), arguments.sets.end());
  return overrides;
}

YamlDocument document_of_log(const LiveArguments& arguments) {
  YamlNode root;
  root.kind = YamlNode::Kind::kMap;
  root.entries.push_back({"log", write_yaml(arguments.played.scenario)});
  put_maps(arguments.recording, root);
  root.entries.push_back({"start", write_yaml(arguments.start)});
  put_topics(arguments.recording, root);
  return YamlDocument(std::move(root));
}

YamlDocument document_of_session(const LiveArguments& arguments) {
  require_no_recording_option(
      arguments,
      ": " + arguments.played.scenario + " states what is played; change it there, or by --set");
  return YamlDocument::load(arguments.played.scenario);
}

/// The log that is to be played; nothing: a scenario is.
std::optional<ReplaySession> session_of_live(const LiveArguments& arguments) {
  const bool has_log = is_log(arguments.played.scenario);
  if (!has_log && !is_session(arguments.played.scenario)) {
    require_no_recording_option(arguments, why_no_log(arguments));
    return std::nullopt;
  }
  require_no_simulation_option(arguments.played);
  YamlDocument document = has_log ? document_of_log(arguments) : document_of_session(arguments);
  for (const std::string& text : overrides_of_log(arguments.played)) document.set(text);
  ReplaySession session = read_session(
      std::move(document), {std::filesystem::path(arguments.played.scenario).parent_path(), {}});
  check_log(session);
  return session;
}

/// runs/live-NAME-1, or the first with a higher number that is free.
std::filesystem::path free_live_folder(const std::string& name) {
  for (int number = 1;; ++number) {
    std::filesystem::path folder = fmt::format("runs/live-{}-{}", file_name_of(name), number);
    if (!std::filesystem::exists(folder)) return folder;
  }
}

/// Plays a scenario whose report somebody asked for.
void play_for_report(const LoadedScenario& loaded, const std::filesystem::path& base,
                     const std::filesystem::path& out) {
  LoadedScenario scenario = loaded;
  scenario.scenario.outputs.report = true;
  PlayOptions options;
  options.base = base;
  options.out = out;
  options.quiet = true;
  options.report = write_report;
  (void)play_to_the_end(scenario, options);
}

/// Starts the process of the run. Returns the line to it.
int start_player(const LiveSetup& setup) {
  return fork_child("the run",
                    [&](int line) {
                      begin_as_worker();
                      std::signal(SIGINT, SIG_IGN);  // Its line is cut when the server ends.
                      play_live(setup, line);
                      return 0;
                    })
      .line;
}

/// Waits until the run has something to say. False: it has ended instead, and has said why.
bool has_begun(int line) {
  char first = 0;
  return recv(line, &first, 1, MSG_PEEK) == 1;
}

LiveServerOptions server_options(const LiveArguments& arguments) {
  LiveServerOptions options;
  options.address = arguments.address;
  options.port = static_cast<std::uint16_t>(arguments.port);
  options.token = random_token();
  return options;
}

/// A line to a run that is over: nobody speaks at the other end, which stays open.
int open_silent_line() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
    throw std::runtime_error("cannot start: no socket");
  }
  return ends[0];
}

int serve(LiveServerOptions options, int line) {
  LiveServer server(std::move(options), line);
  print_out("{}\n", server.url());
  std::fflush(stdout);
  const bool ended = server.serve([](const std::string& text) { say(text); });
  if (!ended) return kDone;
  say("the run ended");
  return kRunFailed;
}

/// Shows the report of a finished run.
int show_run(const LiveArguments& arguments) {
  require_no_simulation_option(arguments.played);
  require_no_recording_option(arguments, ": " + arguments.played.scenario +
                                             " is the folder of a run, whose report is shown; to "
                                             "play its bag, name the folder 'bag' in it");
  const std::filesystem::path report =
      std::filesystem::path(arguments.played.scenario) / "report.html";
  if (!std::filesystem::is_regular_file(report)) {
    throw std::runtime_error("there is no " + report.string() +
                             ": 'castaway report' makes the report of a run's folder");
  }
  LiveServerOptions options = server_options(arguments);
  options.page = read_file(report);
  return serve(std::move(options), open_silent_line());
}

/// The scenario, which of a log is that of the worlds that pages bring.
LoadedScenario scenario_of_live(const LiveArguments& arguments, bool has_log) {
  if (!has_log) return load_scenario(arguments.played.file(), arguments.played.overrides());
  return load_scenario(ScenarioArguments{}.file(), localizer_override(arguments.played.localizers));
}

std::string name_of_live(const LiveSetup& setup) {
  if (!setup.session) return setup.scenario.scenario.name;
  const std::filesystem::path log = setup.session->log;
  return "replay-" + (log.has_filename() ? log : log.parent_path()).stem().stem().string();
}

int run_live(const LiveArguments& arguments) {
  const bool has_log = is_log(arguments.played.scenario);
  if (!has_log && std::filesystem::is_directory(arguments.played.scenario))
    return show_run(arguments);
  std::optional<ReplaySession> session = session_of_live(arguments);
  LiveSetup setup{scenario_of_live(arguments, session.has_value()),
                  session ? "." : arguments.played.file().parent_path(), arguments.play};
  setup.session = std::move(session);
  check_nodes(setup.localizers());
  setup.reports = free_live_folder(name_of_live(setup));
  setup.files = setup.reports / "files";
  setup.report = play_for_report;
  setup.replay = [](const ReplaySession& played, const std::filesystem::path& out) {
    play_replay(played, out, write_report);
  };
  setup.warn = print_warning;
  LiveServerOptions options = server_options(arguments);
  options.page = live_page(name_of_live(setup));
  options.reports = setup.reports;
  options.files = setup.files;
  if (auto bridge = arguments.ros2.bridge()) {
    bridge->pace = 0.0;  // Pages set the speed.
    setup.bridge = start_bridge(bridge_config(*bridge, setup.localizers()));
  }
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // Copies of the run outlive the one that made them.
  std::signal(SIGCHLD, SIG_IGN);     // Nobody waits for them.
  const int line = start_player(setup);
  if (setup.session && !has_begun(line)) return kBadInput;  // Reading a log tells what is amiss.
  return serve(std::move(options), line);
}
}  // namespace

void add_live_command(Command& app) {
  auto a = std::make_shared<LiveArguments>();
  Command command = app.add_command(
      "live", "A run in the browser: kidnap the robot, break sensors, drive, and save it all");
  command.add_option(
      "scenario", a->played.scenario,
      "A scenario's name or file; a recorded log, or what a live run of one saved; or "
      "a finished run's folder (default: lab/kidnap)");
  add_recording_options(command, a->recording);
  command.add_option("--start", a->start, "Of a log: truth or unknown")
      .one_of({"truth", "unknown"})
      .show_default();
  add_scenario_options(command, a->played);
  command.add_option("--port", a->port, "Port; 0: any free one").range(0, 65535).show_default();
  command.add_option("--address", a->address, "IP address to listen on").show_default();
  add_ros2_options(command, a->ros2);
  command.add_flag("--play", a->play, "Play from the beginning on");
  command.footer(
      "Prints the address of the page, with a token without which nobody gets in.\n"
      "Examples:\n"
      "  castaway live\n"
      "  castaway live office/people --port 9000\n"
      "  castaway live --world my_map.yaml --robot my_robot.urdf\n"
      "  castaway live runs/lab-kidnap/seed-1\n"
      "  castaway live intel.log.gz --map intel.yaml\n"
      "  castaway live rosbag2_2026_01_31 --map3d building.bt\n"
      "  castaway live --localizer mh_amcl --localizer amcl --set people.count=10");
  command.action([a] { return run_live(*a); });
}

}  // namespace castaway::testbed
