/// The subcommands of the program. Each adds itself to the command line and describes its options.
#pragma once

#include "tools/base/output/exit_code.hpp"
#include "tools/commands/arguments/command_line.hpp"

namespace castaway::testbed {

/// Adds a subcommand. Its action returns an exit code and throws std::exception for bad input.
void add_run_command(Command& app);
void add_campaign_command(Command& app);
void add_live_command(Command& app);
void add_dataset_command(Command& app);
void add_compare_command(Command& app);
void add_experiment_command(Command& app);
void add_replay_command(Command& app);
void add_bag_command(Command& app);
void add_report_command(Command& app);
void add_evaluate_command(Command& app);
void add_calibrate_command(Command& app);
void add_twin_command(Command& app);
void add_map_command(Command& app);
void add_observation_command(Command& app);
void add_check_robot_command(Command& app);
void add_check_world_command(Command& app);
void add_lidars_command(Command& app);
void add_serve_command(Command& app);
void add_settings_command(Command& app);
void add_list_commands(Command& app);
void add_completion_command(Command& app);
void add_bench_command(Command& app);
void add_help_commands(Command& app);

}  // namespace castaway::testbed
