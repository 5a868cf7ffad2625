#include "tools/play/verdict_output.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/exit_code.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

std::string case_name(const Check& check) {
  const std::string who = check.seed ? fmt::format("seed {}", *check.seed)
                                     : to_string(check.expectation.over) + " of the seeds";
  return fmt::format("{} {} ({})", check.expectation.metric, to_string(check.expectation.condition),
                     who);
}

}  // namespace

JudgedRun load_judged_run(const std::filesystem::path& run_folder) {
  const Json summary = read_json(run_folder / "summary.json");
  const Json timing = read_json(run_folder / "timing.json");
  JudgedRun run;
  read_fields(run_folder / "summary.json", [&] {
    run = {integer<std::uint64_t>(summary.at("seed")), run_folder, metric_table(summary, timing),
           timing.at("wall_s").get<double>()};
  });
  return run;
}

std::vector<JunitCase> junit_cases(const std::string& scenario, const std::vector<Check>& checks) {
  std::vector<JunitCase> cases;
  for (const Check& check : checks) {
    JunitCase test{"castaway." + scenario, case_name(check), check.wall_s, {}, {}};
    if (!check.met) test.failure = describe(check);
    cases.push_back(std::move(test));
  }
  return cases;
}

JunitCase run_case(const std::string& scenario, std::uint64_t seed, double wall_s,
                   std::optional<std::string> error) {
  return {
      "castaway." + scenario, fmt::format("runs (seed {})", seed), wall_s, {}, std::move(error)};
}

std::string describe_checks(const std::vector<Check>& checks) {
  if (checks.empty()) return "";
  const auto met =
      std::count_if(checks.begin(), checks.end(), [](const Check& check) { return check.met; });
  std::string text = fmt::format("\nExpectations: {} of {} met\n", met, checks.size());
  for (const Check& check : checks) {
    if (!check.met) text += fmt::format("  not met: {}\n", describe(check));
  }
  return text;
}

int exit_code_of(const std::vector<Check>& checks) {
  const bool met =
      std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.met; });
  return met ? kDone : kExpectationNotMet;
}

}  // namespace castaway::testbed
