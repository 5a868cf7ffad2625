#include "tools/play/execute.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "tools/base/files/attempts.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/output/any_error.hpp"
#include "tools/base/output/exit_code.hpp"
#include "tools/base/output/say.hpp"
#include "tools/play/progress.hpp"
#include "tools/play/run_summary.hpp"

namespace castaway::testbed {

std::vector<LostLocalizer> execute(Run& run, OutputFolder& output, bool quiet) {
  run.sinks.push_back(std::make_unique<ProgressSink>(run.source->duration(), quiet));
  Loop loop(run.loop, run.localizers, run.sinks);
  Attempts played;
  played.make([&] { loop.run(*run.source); });
  if (!loop.is_finished()) played.rethrow();
  run.sinks.clear();  // Closes their files.
  throw_if_interrupted();
  output.commit(!played.failed());
  played.rethrow();
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
    say(fmt::format("the run failed: {}{}", current_error_text(),
                    output.is_committed() ? "; its other files are in " + target.string() : ""));
    return kRunFailed;
  }
  for (const LostLocalizer& each : lost) {
    say(fmt::format("{}; the run went on without it", describe(each)));
  }
  const int exit_code = lost.empty() ? kDone : kRunFailed;
  if (printing.silent || printing.quiet) return exit_code;
  print_out("{}", printing.json ? read_file(target / "summary.json") : describe_run(target));
  if (!printing.film.empty() && !printing.json) {
    print_out("Film:       {}\n", printing.film.string());
  }
  return exit_code;
}

}  // namespace castaway::testbed
