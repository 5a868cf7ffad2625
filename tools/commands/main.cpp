// The program.
#include <algorithm>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>

#include "tools/base/bytes/utf8.hpp"
#include "tools/base/files/file_error.hpp"
#include "tools/base/output/any_error.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/build/bundled_renderer.hpp"
#include "tools/build/isolated_meshes.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/early_end.hpp"
#include "tools/play/terminal.hpp"
#include "tools/run/localizer_failure.hpp"

namespace castaway::testbed {
namespace {

void print_error(const std::string& text) {
  fmt::print(stderr, "{} {}\n", paint("castaway:", Color::kRed, stderr), printable(text));
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
  add_help_commands(app);
}

/// Parses the arguments and runs the command; returns the exit code.
int run_program(CommandLine& line, const std::vector<std::string>& words) {
  const CommandLine::Parsed parsed = line.parse(words);
  if (parsed.act) return parsed.act();
  if (!parsed.trouble.empty()) fmt::print(stderr, "{}\n", printable(parsed.trouble));
  return parsed.exit_code;
}

int run_main(const std::vector<std::string>& words) {
  CommandLine line(
      "castaway drops a simulated robot somewhere it does not expect and measures how a localizer "
      "finds it again.",
      std::string("castaway ") + CASTAWAY_VERSION);
  add_commands(line.root());
  line.require_whole_seeds();
  watch_for_interruption();
  if (const auto trouble = line.unknown_command(words)) {
    fmt::print(stderr, "{}\n", printable(*trouble));
    return kBadInput;
  }
  isolate_meshes();
  use_renderer_beside("/proc/self/exe");
  try {
    return run_program(line, words);
  } catch (const Interrupted& interrupted) {
    print_error(describe(interrupted));
    return exit_code_of(interrupted);
  } catch (const LocalizerFailure& failure) {
    print_error(failure.what());
    return kRunFailed;
  } catch (const FileError& error) {
    print_error(error.what());
    return kRunFailed;
  } catch (const std::system_error& error) {  // Also std::filesystem's: the disk, not the input.
    print_error(error.what());
    return kRunFailed;
  } catch (...) {
    print_error(current_error_text());
    return kBadInput;
  }
}

}  // namespace
}  // namespace castaway::testbed

/// Also called by libraries that the program loads.
extern "C" void _exit(int status) { castaway::testbed::leave(status); }
extern "C" void _Exit(int status) noexcept { castaway::testbed::leave(status); }

int main(int argc, char** argv) {
  using namespace castaway::testbed;
  watch_for_early_end();
  int exit_code = run_main(replace_help_words({argv + std::min(argc, 1), argv + argc}));
  if (exit_code == kDone && std::fflush(stdout) != 0) {
    print_error("standard output cannot be written; check that the disk is not full");
    exit_code = kRunFailed;
  }
  note_end();
  return exit_code;
}
