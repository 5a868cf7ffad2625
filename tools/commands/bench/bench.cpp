// castaway bench: benchmarks that users run on their machines, worlds and localizers; those of the
// project are tests/bench.
#include "tools/commands/bench/bench.hpp"

namespace castaway::testbed {

void add_bench_command(Command& app) {
  Command bench =
      app.add_command("bench", "Measure the localizers and the simulator: one table a command");
  bench.require_command();
  add_bench_calibration(bench);
  add_bench_kidnaps(bench);
  add_bench_localization(bench);
  add_bench_simulation(bench);
}

}  // namespace castaway::testbed
