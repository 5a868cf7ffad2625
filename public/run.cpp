#include "castaway/run.hpp"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "public/play.hpp"
#include "public/read_scenario.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/pages/run/report.hpp"
#include "tools/play/play.hpp"
#include "tools/play/verdict_output.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway {
namespace {

testbed::PlayOptions play_options(const ReadScenario& read, const PlayRequest& request,
                                  RunResult& result) {
  testbed::PlayOptions options;
  options.base = read.file.parent_path();
  options.inputs = inputs_of(read.loaded.scenario, read.file);
  options.out = request.out;
  options.force = request.force;
  options.quiet = true;
  options.report = testbed::write_report;
  options.warn = [&result](const std::string& warning) { result.warnings.push_back(warning); };
  options.watcher = request.watcher;
  return options;
}

std::vector<std::string> missed_by(const testbed::Scenario& scenario,
                                   const std::filesystem::path& folder) {
  std::vector<std::string> missed;
  if (scenario.expect.empty()) return missed;
  for (const testbed::Check& check : judge(scenario.expect, {testbed::load_judged_run(folder)})) {
    if (!check.met) missed.push_back(describe(check));
  }
  return missed;
}

/// A localizer as an element of a scenario's list.
std::string yaml_of(const AnyLocalizer& localizer) {
  if (const auto* text = std::get_if<std::string>(&localizer)) {
    return testbed::localizer_yaml(*text);
  }
  const nlohmann::ordered_json name = std::get<OwnLocalizer>(localizer).name;
  return fmt::format("{{own: {{name: {}}}}}", testbed::json_text(name));
}

}  // namespace

testbed::OwnConfig own_config(const OwnLocalizer& own) {
  return {[make = own.make](const testbed::Greeting& greeting) {
    return make({greeting.name, greeting.seed, to_occupancy_grid(greeting.map)});
  }};
}

RunResult play(const Scenario& scenario, const PlayRequest& request) {
  ReadScenario read = read_scenario(scenario);
  for (testbed::LocalizerSpec& spec : read.loaded.scenario.localizers) {
    const auto own = request.own.find(spec.name);
    if (own != request.own.end()) spec.config = own->second;
  }
  RunResult result;
  for (const auto& lost : play_to_the_end(read.loaded, play_options(read, request, result))) {
    result.failed[lost.name] = lost.what;
  }
  result.missed = missed_by(read.loaded.scenario, request.out);
  return result;
}

RunResult run(const Scenario& scenario, const RunOptions& options) {
  Scenario with_localizers = scenario;
  PlayRequest request{options.out, options.force};
  std::vector<std::string> list;
  for (const AnyLocalizer& localizer : options.localizers) {
    list.push_back(yaml_of(localizer));
    const auto* own = std::get_if<OwnLocalizer>(&localizer);
    if (own != nullptr) request.own[own->name] = own_config(*own);
  }
  if (!list.empty()) {
    with_localizers.set("localizers", fmt::format("[{}]", fmt::join(list, ", ")));
  }
  RunResult result = play(with_localizers, request);
  result.summary = testbed::read_file(options.out / "summary.json");
  return result;
}

}  // namespace castaway
