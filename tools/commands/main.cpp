// The program.
#include <cstdio>
#include <exception>

#include "tools/commands/commands.hpp"

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
  add_bench_command(app, chosen);
  try {
    app.parse(argc, argv);
    return chosen();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kDone : kBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "castaway: %s\n", error.what());
    return kBadInput;
  }
}
