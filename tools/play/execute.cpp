#include "tools/play/execute.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "tools/files/file.hpp"
#include "tools/output/exit_code.hpp"
#include "tools/play/progress.hpp"
#include "tools/play/run_summary.hpp"

namespace castaway::testbed {

void execute(Run& run, OutputFolder& output, bool quiet) {
  run.sinks.push_back(std::make_unique<ProgressSink>(run.source->duration(), quiet));
  Loop(run.loop, run.localizers, run.sinks).run(*run.source);
  run.sinks.clear();  // Closes their files.
  throw_if_interrupted();
  output.commit();
}

int execute_and_print(Run& run, OutputFolder& output, const std::filesystem::path& target,
                      const Printing& printing) {
  try {
    execute(run, output, printing.quiet);
  } catch (const std::exception& error) {
    run.sinks.clear();       // Removes the progress line.
    throw_if_interrupted();  // A signal also interrupts ffmpeg, and is then the cause of the error.
    fmt::print(stderr, "castaway: the run failed: {}\n", error.what());
    return kRunFailed;
  }
  if (printing.silent || printing.quiet) return kDone;
  fmt::print("{}", printing.json ? read_file(target / "summary.json") : describe_run(target));
  if (!printing.film.empty() && !printing.json) {
    fmt::print("Film:       {}\n", printing.film.string());
  }
  return kDone;
}

}  // namespace castaway::testbed
