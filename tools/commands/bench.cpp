// castaway bench: the project's own measurements, each by one command.
#include "tools/commands/bench.hpp"

namespace castaway::testbed {

void add_bench_command(CLI::App& app, std::function<int()>& chosen) {
  CLI::App* bench =
      app.add_subcommand("bench", "Measure the localizers and the simulator: one table a command");
  bench->require_subcommand(1);
  add_bench_crowds(*bench, chosen);
  add_bench_kidnaps(*bench, chosen);
  add_bench_localization(*bench, chosen);
  add_bench_odometry(*bench, chosen);
  add_bench_physics(*bench, chosen);
  add_bench_published(*bench, chosen);
  add_bench_simulation(*bench, chosen);
}

}  // namespace castaway::testbed
