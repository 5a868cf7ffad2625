#include "castaway/evaluate.hpp"

#include <nlohmann/json.hpp>

#include "public/play.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/batch/evaluate/evaluation.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway {
namespace {

testbed::LocalizerSpec spec_of(const AnyLocalizer& localizer) {
  if (const auto* text = std::get_if<std::string>(&localizer)) {
    return testbed::parse_localizer(*text);
  }
  const auto& own = std::get<OwnLocalizer>(localizer);
  return {own.name, own_config(own)};
}

testbed::EvaluationConfig config_of(const EvaluateOptions& options) {
  testbed::EvaluationConfig config;
  config.starts = options.starts;
  config.kidnaps = options.kidnaps;
  config.window_s = options.window_s;
  config.kidnap_to = testbed::parse_splice_kind(options.kidnap_to);
  config.tracking = options.tracking;
  config.seed = options.seed;
  return config;
}

}  // namespace

std::vector<std::string> evaluate(const std::vector<std::filesystem::path>& folders,
                                  const std::vector<AnyLocalizer>& localizers,
                                  const EvaluateOptions& options) {
  const testbed::EvaluationConfig config = config_of(options);
  std::vector<testbed::LocalizerSpec> specs;
  for (const AnyLocalizer& localizer : localizers) specs.push_back(spec_of(localizer));
  const testbed::PlaceMaps maps = testbed::maps_for(specs, {options.map3d, {}});
  std::vector<std::string> rows;
  for (const std::filesystem::path& folder : folders) {
    const testbed::RecordedPlace place = testbed::load_recorded_place(folder.string(), maps);
    for (const testbed::LocalizerSpec& spec : specs) {
      rows.push_back(testbed::json_text(to_json(testbed::evaluate(place, spec, config))));
    }
  }
  return rows;
}

}  // namespace castaway
