// castaway report: pages of finished runs, made again.
#include <memory>

#include <fmt/format.h>

#include "tools/commands/commands.hpp"
#include "tools/output/own_file.hpp"
#include "tools/report/report.hpp"
#include "tools/report/runs_page.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// What the command line says.
struct ReportArguments {
  std::vector<std::string> runs;
  std::string out;
};

/// In the place of the one that castaway wrote, and of no other.
void remake_report(const fs::path& run) {
  const fs::path page = run / "report.html";
  require_own_file(page);
  put_own_file(page, [&] { write_report(run, std::nullopt); });
}

int make_reports(const ReportArguments& arguments) {
  std::vector<fs::path> folders;
  for (const std::string& run : arguments.runs) {
    if (!fs::is_directory(run)) {
      throw std::invalid_argument(run +
                                  ": no such folder; give the run folder that castaway run "
                                  "printed at its end");
    }
    folders.emplace_back(run);
    remake_report(folders.back());
    fmt::print("{}\n", (folders.back() / "report.html").string());
  }
  if (folders.size() < 2 && arguments.out.empty()) return kDone;
  const fs::path page = arguments.out.empty() ? fs::path("runs.html") : fs::path(arguments.out);
  put_own_file(page, [&] { write_runs_page(folders, page); });
  fmt::print("{}\n", page.string());
  return kDone;
}

}  // namespace

void add_report_command(CLI::App& app, std::function<int()>& chosen) {
  auto a = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand(
      "report", "Make report.html of run folders again; of several also a page that leads to them");
  command->add_option("runs", a->runs, "Run folders")->required();
  command->add_option("--out", a->out, "Page that leads to the runs (default: runs.html)");
  command->footer(
      "Examples:\n"
      "  castaway report runs/lab-kidnap/seed-1\n"
      "  castaway report runs/lab-kidnap/* --out runs/lab-kidnap/index.html");
  command->callback([&chosen, a] { chosen = [a] { return make_reports(*a); }; });
}

}  // namespace castaway::testbed
