/// The subcommands of the program. Each adds itself to the command line and says what its options
/// are.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace castaway::testbed {

/// Exit codes of the program.
enum ExitCode : int {
  kDone = 0,
  kRunFailed = 1,
  kBadInput = 2,
  kExpectationNotMet = 3,
};

/// Adds a subcommand; `chosen` is set to its action when it is on the command line. Actions return
/// an exit code and throw std::exception for bad input.
void add_run_command(CLI::App& app, std::function<int()>& chosen);
void add_dataset_command(CLI::App& app, std::function<int()>& chosen);
void add_compare_command(CLI::App& app, std::function<int()>& chosen);
void add_experiment_command(CLI::App& app, std::function<int()>& chosen);
void add_replay_command(CLI::App& app, std::function<int()>& chosen);
void add_bag_command(CLI::App& app, std::function<int()>& chosen);
void add_report_command(CLI::App& app, std::function<int()>& chosen);
void add_evaluate_command(CLI::App& app, std::function<int()>& chosen);
void add_map_command(CLI::App& app, std::function<int()>& chosen);
void add_check_robot_command(CLI::App& app, std::function<int()>& chosen);
void add_check_world_command(CLI::App& app, std::function<int()>& chosen);
void add_lidars_command(CLI::App& app, std::function<int()>& chosen);
void add_list_commands(CLI::App& app, std::function<int()>& chosen);
void add_completion_command(CLI::App& app, std::function<int()>& chosen);
void add_bench_command(CLI::App& app, std::function<int()>& chosen);

}  // namespace castaway::testbed
