// castaway bench: the project's own benchmarks, one command each.
#include "tools/commands/bench/bench.hpp"

namespace castaway::testbed {

void add_bench_command(Command& app) {
  Command bench =
      app.add_command("bench", "Measure the localizers and the simulator: one table a command");
  bench.require_command();
  add_bench_calibration(bench);
  add_bench_crowds(bench);
  add_bench_kidnaps(bench);
  add_bench_localization(bench);
  add_bench_odometry(bench);
  add_bench_physics(bench);
  add_bench_published(bench);
  add_bench_simulation(bench);
}

}  // namespace castaway::testbed
