#include "tools/twin/twin_run.hpp"

#include <algorithm>
#include <cmath>

#include "tools/build/build_simulation.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/scenario/files/ros_map_file.hpp"
#include "tools/scenario/scenario_file.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {

namespace {

RecordedPlace run_document(YamlDocument document, const std::filesystem::path& folder,
                           std::uint64_t seed) {
  document.set("seed=" + std::to_string(seed));
  const LoadedScenario loaded = read_scenario(std::move(document), folder, "twin");
  PreparedSimulation prepared = build_simulation(loaded.scenario, folder);
  RecordedPlace place;
  place.name = "twin";
  place.map = prepared.map;
  const Stamp duration = prepared.config.duration;
  std::vector<sim::LidarConfig> lidars = prepared.config.lidars;
  SimulatorSource source(sim::Simulation(std::move(prepared.config), simulation_streams(seed)),
                         std::move(lidars), duration);
  while (auto frame = source.next()) place.frames.push_back(std::move(*frame));
  return place;
}

}  // namespace

RecordedPlace run_scenario(const std::string& scenario, std::uint64_t seed) {
  return run_document(YamlDocument::parse(scenario, "scenario"), ".", seed);
}

RecordedPlace run_twin(const std::filesystem::path& folder, const std::string& scenario,
                       std::uint64_t seed) {
  YamlDocument document = YamlDocument::parse(scenario, (folder / "scenario.yaml").string());
  const auto set_file = [&](const std::string& key, const char* name) {
    document.set_text(key, std::filesystem::absolute(folder / name).string());
  };
  set_file("world.name", "world.yaml");
  set_file("world.map", "map.yaml");
  set_file("drive.path", "path.tum");
  set_file("lidar.scan_times", "scan_times.txt");
  return run_document(std::move(document), folder, seed);
}

namespace {

constexpr double kMostPeople = 200.0;

double moving_count_of_twin(const std::filesystem::path& folder, const FittedLog& fitted,
                            int people, std::uint64_t seed) {
  const RecordedPlace twin = run_twin(folder, twin_scenario(fitted, people), seed);
  const auto building = fit_building(align_log(twin, AlignBy::kTruth));
  return building ? building->moving_count.value : 0.0;
}

}  // namespace

Figure fit_people(const std::filesystem::path& folder, const FittedLog& fitted) {
  constexpr double kFewest = 0.05;  // Objects that are worth a person.
  constexpr int kRounds = 3;
  if (!fitted.fit.building || fitted.fit.building->moving_count.value < kFewest) return {};
  const Figure& wanted = fitted.fit.building->moving_count;
  double count = std::clamp(0.4 * fitted.fit.building->moving_count.value, 1.0, kMostPeople);
  double seen = 0.0;
  double people = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    const int tried = static_cast<int>(std::lround(std::clamp(count, 1.0, kMostPeople)));
    const auto seed = static_cast<std::uint64_t>(round + 1);
    seen += moving_count_of_twin(folder, fitted, tried, seed);
    people += tried;
    if (seen <= 0.0) return {count, {0.0, kMostPeople}};
    count = people * wanted.value / seen;
  }
  const double per_object = people / seen;
  constexpr double kModel = 0.1;  // Relative; people in the twin do not meet the same robot.
  count = std::min(count, kMostPeople);
  const Figure figure{count, {per_object * wanted.interval.low, per_object * wanted.interval.high}};
  Figure wide = widen(figure, kModel * count);
  wide.interval.low = std::max(wide.interval.low, 0.0);
  return wide;
}

std::optional<MixedFit> fit_mixed_beyond(const std::filesystem::path& folder, FittedLog fitted,
                                         int people) {
  fitted.fit.mixed.reset();
  const RecordedPlace twin = run_twin(folder, twin_scenario(fitted, people), 1);
  return fit_mixed(fitted.log, shares_in_between(align_log(twin, AlignBy::kTruth)));
}

}  // namespace castaway::testbed
