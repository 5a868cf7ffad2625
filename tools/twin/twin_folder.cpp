#include "tools/twin/twin_folder.hpp"

#include <cmath>

#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/twin/fits/wall_fit.hpp"
#include "tools/twin/twin_run.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {
namespace {

nlohmann::ordered_json samples_json(const LikeSamples& samples) {
  return {{"name", samples.name},
          {"unit", samples.unit},
          {"log_median", percentile(samples.log, 0.5)},
          {"log_p90", percentile(samples.log, 0.9)},
          {"twin_median", percentile(samples.twin, 0.5)},
          {"twin_p90", percentile(samples.twin, 0.9)},
          {"wasserstein", wasserstein_distance(samples.log, samples.twin)}};
}

void write_parts(const FittedLog& fitted, int people, const std::filesystem::path& folder) {
  write_file(folder / "lidar.yaml", lidar_text(fitted));
  write_file(folder / "odometry.yaml", odometry_text(fitted));
  write_file(folder / "people.yaml", people_text(people));
  const std::string differences = differences_text(fitted);
  if (!differences.empty()) write_file(folder / "differences.yaml", differences);
}

}  // namespace

void write_twin_inputs(const RosMap& map, const FittedLog& fitted,
                       const std::filesystem::path& folder) {
  write_ros_map(map, folder / "map.yaml");
  write_ros_map(fitted.building, folder / "world.yaml");
  write_file(folder / "path.tum", path_text(fitted));
  write_file(folder / "scan_times.txt", scan_times_text(fitted.log));
}

Twin build_twin(const RecordedPlace& place, AlignBy by, const std::filesystem::path& folder) {
  Twin twin{fit_log(place, {.align = by, .track = kTwinTrack}), {}, {}, {}};
  write_twin_inputs(place.map, twin.fitted, folder);
  twin.people = fit_people(folder, twin.fitted);
  const int people = static_cast<int>(std::lround(twin.people.value));
  twin.fitted.fit.mixed = fit_mixed_beyond(folder, twin.fitted, people);
  const std::string scenario = twin_scenario(twin.fitted, people);
  write_parts(twin.fitted, people, folder);
  write_file(folder / "scenario.yaml", scenario);
  ScanCorrection correction;
  correction.walls = twin.fitted.walls;
  twin.run = run_twin(folder, scenario, 1);
  AlignedLog aligned = align_log(twin.run, AlignBy::kTruth, correction);
  if (!looks_around(aligned)) move_back(aligned);
  twin.likeness = compare_logs(twin.fitted.log, aligned);
  write_file(folder / "calibration.json", json_text(to_json(twin), 1) + "\n");
  return twin;
}

nlohmann::ordered_json to_json(const Twin& twin) {
  nlohmann::ordered_json json = to_json(twin.fitted);
  json["people"] = to_json(twin.people);
  json["likeness"] = nlohmann::ordered_json::array();
  for (const LikeSamples& samples : twin.likeness.samples)
    json["likeness"].push_back(samples_json(samples));
  return json;
}

}  // namespace castaway::testbed
