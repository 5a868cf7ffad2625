#include "castaway/scenario.hpp"

#include "public/read_scenario.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway {

ReadScenario read_scenario(const Scenario& scenario) {
  const auto programs =
      scenario.allow_programs ? testbed::FilePrograms::kAllowed : testbed::FilePrograms::kRefused;
  const std::filesystem::path file = testbed::find_scenario(scenario.file, ".");
  return {file, testbed::load_scenario(file, scenario.changes, programs)};
}

std::string effective_text(const Scenario& scenario) {
  return read_scenario(scenario).loaded.effective;
}

std::vector<std::string> scenario_names() { return testbed::scenario_names(); }

void set_data_folder(const std::filesystem::path& folder) { testbed::set_shipped_data(folder); }

}  // namespace castaway
