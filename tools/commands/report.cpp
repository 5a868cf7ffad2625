// castaway report: renders the pages of finished runs again.
#include <memory>

#include <fmt/format.h>

#include "tools/base/output/own_file.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/compare/comparison.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/run/report.hpp"
#include "tools/pages/runs/runs_page.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// Arguments of the command.
struct ReportArguments {
  std::vector<std::string> runs;
  std::string out;
};

/// The run folders among the arguments: those given, and those inside folders of runs (`run
/// --seeds`). Files matched by a shell's `DIR/*` are skipped.
std::vector<fs::path> run_folders(const ReportArguments& arguments) {
  std::vector<fs::path> folders;
  for (const std::string& given : arguments.runs) {
    if (arguments.runs.size() > 1 && fs::is_regular_file(given)) continue;
    if (!fs::is_directory(given)) {
      throw std::invalid_argument(given +
                                  ": no such folder; give the run folder that castaway run "
                                  "printed at its end");
    }
    for (const ComparedRun& run : find_runs(given)) folders.push_back(run.folder);
  }
  if (folders.empty()) throw std::invalid_argument("no run folder is given");
  return folders;
}

int make_reports(const ReportArguments& arguments) {
  const std::vector<fs::path> folders = run_folders(arguments);
  for (const fs::path& folder : folders) {
    remake_report(folder);
    print_out("{}\n", (folder / "report.html").string());
  }
  if (folders.size() < 2 && arguments.out.empty()) return kDone;
  const fs::path page = arguments.out.empty() ? fs::path("runs.html") : fs::path(arguments.out);
  write_own_file(page, render_runs_page({.folders = folders, .page = page}));
  print_out("{}\n", page.string());
  return kDone;
}

}  // namespace

void add_report_command(Command& app) {
  auto a = std::make_shared<ReportArguments>();
  Command command = app.add_command(
      "report", "Render report.html of run folders again, and an index page if there are several");
  command.add_option("runs", a->runs, "Run folders, or folders of runs").required();
  command.add_option("--out", a->out, "Index page of the runs (default: runs.html)");
  command.footer(
      "Examples:\n"
      "  castaway report runs/lab-kidnap/seed-1\n"
      "  castaway report runs/lab-kidnap/* --out runs/lab-kidnap/index.html");
  command.action([a] { return make_reports(*a); });
}

}  // namespace castaway::testbed
