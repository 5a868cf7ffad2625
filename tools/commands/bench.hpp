/// The measurements of `castaway bench`. Each stands in a file of its own, bench_<name>.cpp, and
/// adds itself as a subcommand with a function that is declared here.
#pragma once

#include "tools/commands/commands.hpp"

namespace castaway::testbed {

void add_bench_crowds(CLI::App& bench, std::function<int()>& chosen);
void add_bench_kidnaps(CLI::App& bench, std::function<int()>& chosen);
void add_bench_localization(CLI::App& bench, std::function<int()>& chosen);
void add_bench_odometry(CLI::App& bench, std::function<int()>& chosen);
void add_bench_physics(CLI::App& bench, std::function<int()>& chosen);
void add_bench_published(CLI::App& bench, std::function<int()>& chosen);
void add_bench_simulation(CLI::App& bench, std::function<int()>& chosen);

}  // namespace castaway::testbed
