/// The measurements of `castaway bench`. Each stands in a file of its own, bench_<name>.cpp, and
/// adds itself as a subcommand with a function that is declared here.
#pragma once

#include "tools/commands/commands.hpp"

namespace castaway::testbed {

void add_bench_crowds(Command& bench);
void add_bench_kidnaps(Command& bench);
void add_bench_localization(Command& bench);
void add_bench_odometry(Command& bench);
void add_bench_physics(Command& bench);
void add_bench_published(Command& bench);
void add_bench_simulation(Command& bench);

}  // namespace castaway::testbed
