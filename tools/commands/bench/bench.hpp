/// The benchmarks of `castaway bench`. Each file bench_<name>.cpp adds its subcommand with a
/// function declared here.
#pragma once

#include "tools/commands/commands.hpp"

namespace castaway::testbed {

void add_bench_calibration(Command& bench);
void add_bench_kidnaps(Command& bench);
void add_bench_localization(Command& bench);
void add_bench_simulation(Command& bench);

}  // namespace castaway::testbed
