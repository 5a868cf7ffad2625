// Compares ray casts in all shipped worlds with a plain loop over their objects. Usage:
// world_cast_check [millions of beams]; exit code 1 if a range differs by more than 0.1 mm.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "tests/sim/support/world_oracle.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/world/world_file.hpp"

int main(int argc, char** argv) {
  using namespace castaway;
  const double millions = argc > 1 ? std::atof(argv[1]) : 1.0;
  std::vector<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(testbed::data_root() / "worlds")) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  const long beams = static_cast<long>(1e6 * millions) / static_cast<long>(folders.size()) + 1;
  long wrong = 0;
  for (const auto& folder : folders) {
    const testbed::WorldFile world = testbed::load_world(folder);
    const sim::CastComparison result = sim::compare_casts(world.spec, beams, 11);
    std::printf("%-10s %9ld beams, %9ld hits: %ld off by more than 0.1 mm; worst %.2g m\n",
                world.spec.name.c_str(), result.beams, result.hits, result.wrong, result.worst);
    wrong += result.wrong;
  }
  return wrong == 0 ? 0 : 1;
}
