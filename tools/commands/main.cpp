// The program.
#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "tools/commands/commands.hpp"
#include "tools/commands/usage.hpp"
#include "tools/output/interruption.hpp"
#include "tools/play/terminal.hpp"
#include "tools/workers/isolated_meshes.hpp"

namespace {

void print_trouble(const std::string& text) {
  using namespace castaway::testbed;
  fmt::print(stderr, "{} {}\n", paint("castaway:", Color::kRed, stderr), text);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace castaway::testbed;
  CLI::App app(
      "castaway drops a simulated robot somewhere it does not expect and measures how a localizer "
      "finds it again.");
  app.set_version_flag("--version", std::string("castaway ") + CASTAWAY_VERSION);
  app.require_subcommand(1);
  std::function<int()> chosen;
  add_run_command(app, chosen);
  add_experiment_command(app, chosen);
  add_compare_command(app, chosen);
  add_dataset_command(app, chosen);
  add_replay_command(app, chosen);
  add_evaluate_command(app, chosen);
  add_bag_command(app, chosen);
  add_report_command(app, chosen);
  add_map_command(app, chosen);
  add_check_robot_command(app, chosen);
  add_check_world_command(app, chosen);
  add_lidars_command(app, chosen);
  add_list_commands(app, chosen);
  add_bench_command(app, chosen);
  add_completion_command(app, chosen);
  require_whole_seeds(app);
  watch_for_interruption();
  if (const auto trouble = unknown_command(app, {argv + 1, argv + argc})) {
    fmt::print(stderr, "{}\n", *trouble);
    return kBadInput;
  }
  isolate_meshes();
  try {
    app.parse(argc, argv);
    return chosen();
  } catch (const Interrupted& interrupted) {
    print_trouble(describe(interrupted));
    return exit_code_of(interrupted);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    fmt::print(stderr, "{}\n", describe_usage(app, error));
    return kBadInput;
  } catch (const std::exception& error) {
    print_trouble(error.what());
    return kBadInput;
  }
}
