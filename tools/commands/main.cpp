// The program.
#include <cstdio>

#include <fmt/format.h>

#include "tools/commands/commands.hpp"
#include "tools/output/any_error.hpp"
#include "tools/output/interruption.hpp"
#include "tools/play/terminal.hpp"
#include "tools/run/localizer_failure.hpp"
#include "tools/workers/isolated_meshes.hpp"

namespace castaway::testbed {
namespace {

void print_error(const std::string& text) {
  fmt::print(stderr, "{} {}\n", paint("castaway:", Color::kRed, stderr), text);
}

void add_commands(Command app) {
  add_run_command(app);
  add_experiment_command(app);
  add_compare_command(app);
  add_dataset_command(app);
  add_campaign_command(app);
  add_live_command(app);
  add_replay_command(app);
  add_evaluate_command(app);
  add_calibrate_command(app);
  add_twin_command(app);
  add_bag_command(app);
  add_report_command(app);
  add_map_command(app);
  add_observation_command(app);
  add_check_robot_command(app);
  add_check_world_command(app);
  add_lidars_command(app);
  add_serve_command(app);
  add_settings_command(app);
  add_list_commands(app);
  add_bench_command(app);
  add_completion_command(app);
}

/// Parses the arguments and runs the command; returns the exit code.
int run_program(CommandLine& line, int argc, char** argv) {
  const CommandLine::Parsed parsed = line.parse(argc, argv);
  if (parsed.act) return parsed.act();
  if (!parsed.trouble.empty()) fmt::print(stderr, "{}\n", parsed.trouble);
  return parsed.exit_code;
}

}  // namespace
}  // namespace castaway::testbed

int main(int argc, char** argv) {
  using namespace castaway::testbed;
  CommandLine line(
      "castaway drops a simulated robot somewhere it does not expect and measures how a localizer "
      "finds it again.",
      std::string("castaway ") + CASTAWAY_VERSION);
  add_commands(line.root());
  line.require_whole_seeds();
  watch_for_interruption();
  if (const auto trouble = line.unknown_command({argv + 1, argv + argc})) {
    fmt::print(stderr, "{}\n", *trouble);
    return kBadInput;
  }
  isolate_meshes();
  try {
    return run_program(line, argc, argv);
  } catch (const Interrupted& interrupted) {
    print_error(describe(interrupted));
    return exit_code_of(interrupted);
  } catch (const LocalizerFailure& failure) {
    print_error(failure.what());
    return kRunFailed;
  } catch (...) {
    print_error(current_error_text());
    return kBadInput;
  }
}
