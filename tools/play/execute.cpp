#include "tools/play/execute.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "tools/files/file.hpp"
#include "tools/output/any_error.hpp"
#include "tools/output/exit_code.hpp"
#include "tools/play/progress.hpp"
#include "tools/play/run_summary.hpp"

namespace castaway::testbed {

std::vector<LostLocalizer> execute(Run& run, OutputFolder& output, bool quiet) {
  run.sinks.push_back(std::make_unique<ProgressSink>(run.source->duration(), quiet));
  Loop loop(run.loop, run.localizers, run.sinks);
  loop.run(*run.source);
  run.sinks.clear();  // Closes their files.
  throw_if_interrupted();
  output.commit();
  return loop.lost();
}

int execute_and_print(Run& run, OutputFolder& output, const std::filesystem::path& target,
                      const Printing& printing) {
  std::vector<LostLocalizer> lost;
  try {
    lost = execute(run, output, printing.quiet);
  } catch (...) {
    run.sinks.clear();       // Removes the progress line.
    throw_if_interrupted();  // A signal also interrupts ffmpeg, and is then the cause of the error.
    fmt::print(stderr, "castaway: the run failed: {}\n", current_error_text());
    return kRunFailed;
  }
  for (const LostLocalizer& each : lost) {
    fmt::print(stderr, "castaway: {}; the run went on without it\n", describe(each));
  }
  const int exit_code = lost.empty() ? kDone : kRunFailed;
  if (printing.silent || printing.quiet) return exit_code;
  fmt::print("{}", printing.json ? read_file(target / "summary.json") : describe_run(target));
  if (!printing.film.empty() && !printing.json) {
    fmt::print("Film:       {}\n", printing.film.string());
  }
  return exit_code;
}

}  // namespace castaway::testbed
