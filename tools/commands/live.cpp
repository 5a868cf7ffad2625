// castaway live: a run in the browser, with hands.
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/live/live_page.hpp"
#include "tools/live/live_player.hpp"
#include "tools/live/server/live_server.hpp"
#include "tools/live/server/live_token.hpp"
#include "tools/output/exit_code.hpp"
#include "tools/output/interruption.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

struct LiveArguments {
  std::string scenario;
  std::vector<std::string> sets;
  std::vector<std::string> localizers;
  std::string address = "127.0.0.1";
  int port = 8080;
  bool play = false;
};

std::filesystem::path file_of_live(const LiveArguments& arguments) {
  if (arguments.scenario.empty()) return data_root() / "worlds/lab/scenarios/kidnap.yaml";
  return find_scenario(arguments.scenario, ".");
}

std::vector<std::string> overrides_of_live(const LiveArguments& arguments) {
  std::vector<std::string> overrides = localizer_override(arguments.localizers);
  overrides.insert(overrides.end(), arguments.sets.begin(), arguments.sets.end());
  return overrides;
}

/// A copy of the run's process would speak to the same program.
void refuse_programs(const std::vector<LocalizerSpec>& localizers) {
  for (const LocalizerSpec& localizer : localizers) {
    if (!std::holds_alternative<ProgramConfig>(localizer.config)) continue;
    throw std::runtime_error("localizer '" + localizer.name +
                             "' is a program, with which a live run cannot go back; use a library");
  }
}

/// Starts the process of the run. Returns the line to it.
int start_player(const LiveSetup& setup) {
  std::array<int, 2> ends{};  // Ours, the run's.
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
    throw std::runtime_error("cannot start the run: no socket");
  }
  std::fflush(nullptr);  // Buffered output would be written twice.
  const pid_t process = fork();
  if (process < 0) throw std::runtime_error("cannot start the run: no process");
  if (process == 0) {
    close(ends[0]);
    begin_as_worker();
    std::signal(SIGINT, SIG_IGN);  // Its line is cut when the server ends.
    play_live(setup, ends[1]);
    _exit(0);
  }
  close(ends[1]);
  return ends[0];
}

int run_live(const LiveArguments& arguments) {
  const std::filesystem::path file = file_of_live(arguments);
  LiveSetup setup{load_scenario(file, overrides_of_live(arguments)), file.parent_path(),
                  arguments.play};
  refuse_programs(setup.scenario.scenario.localizers);
  LiveServerOptions options;
  options.address = arguments.address;
  options.port = static_cast<std::uint16_t>(arguments.port);
  options.token = random_token();
  options.page = live_page(setup.scenario.scenario.name);
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // Copies of the run outlive the one that made them.
  std::signal(SIGCHLD, SIG_IGN);     // Nobody waits for them.
  LiveServer server(std::move(options), start_player(setup));
  fmt::print("{}\n", server.url());
  std::fflush(stdout);
  const bool ended =
      server.serve([](const std::string& line) { fmt::print(stderr, "castaway: {}\n", line); });
  if (!ended) return kDone;
  fmt::print(stderr, "castaway: the run ended\n");
  return kRunFailed;
}

}  // namespace

void add_live_command(Command& app) {
  auto a = std::make_shared<LiveArguments>();
  Command command = app.add_command(
      "live", "A run in the browser: kidnap the robot, break sensors, drive, and save it all");
  command.add_option("scenario", a->scenario, "A scenario's name or file (default: lab/kidnap)");
  command.add_option("--set", a->sets, "key=value, as in a scenario; repeat for several")
      .repeatable();
  command
      .add_option("--localizer", a->localizers,
                  "NAME, NAME:PRESET, program:COMMAND or library:FILE, in place of the scenario's; "
                  "repeat for several")
      .repeatable();
  command.add_option("--port", a->port, "Port; 0: any free one").range(0, 65535).show_default();
  command.add_option("--address", a->address, "IP address to listen on").show_default();
  command.add_flag("--play", a->play, "Play from the beginning on");
  command.footer(
      "Prints the address of the page, with a token without which nobody gets in.\n"
      "Examples:\n"
      "  castaway live\n"
      "  castaway live office/people --port 9000\n"
      "  castaway live --localizer mh_amcl --localizer amcl --set people.count=10");
  command.action([a] { return run_live(*a); });
}

}  // namespace castaway::testbed
