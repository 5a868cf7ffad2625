#include "tools/outputs/records/recording_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/base/bytes/varint.hpp"
#include "tools/outputs/records/recording.hpp"

namespace castaway::testbed {
namespace {

using localization::PopulationView;

void append_pose(std::string& block, const SE2& pose) {
  append_signed(block, quantize(pose.x, kRecordingPoint));
  append_signed(block, quantize(pose.y, kRecordingPoint));
  append_signed(block, quantize(pose.yaw, kRecordingAngle));
}

/// About `most` of the particles at a regular stride, relative to `center`. They are sorted by x
/// and y, since their order has no meaning and sorted differences are smaller.
std::vector<std::pair<std::int64_t, std::int64_t>> points_about(const SE2& center,
                                                                const std::vector<SE2>& particles,
                                                                std::size_t most) {
  std::vector<std::pair<std::int64_t, std::int64_t>> points;
  const std::size_t stride = beam_stride(particles.size(), most);
  for (std::size_t i = 0; i < particles.size(); i += stride) {
    points.emplace_back(quantize(particles[i].x - center.x, kRecordingPoint),
                        quantize(particles[i].y - center.y, kRecordingPoint));
  }
  std::sort(points.begin(), points.end());
  return points;
}

void append_population(std::string& block, const PopulationView& population, std::size_t most,
                       bool heights) {
  append_signed(block, population.id);
  append_varint(block, population.selected ? 1U : 0U);
  append_signed(block, quantize(population.share, kRecordingShare));
  append_signed(block, quantize(population.quality, kRecordingShare));
  append_pose(block, population.T_map_base);
  if (heights) {
    const double z = population.footing ? population.footing->z : 0.0;
    append_signed(block, quantize(z, kRecordingPoint));
  }
  const auto points = points_about(population.T_map_base, population.particles, most);
  append_varint(block, points.size());
  std::int64_t last_x = 0;
  for (const auto& [x, y] : points) {
    append_signed(block, x - last_x);
    append_signed(block, y);
    last_x = x;
  }
}

}  // namespace

std::size_t beam_stride(std::size_t beams, std::size_t most) {
  return std::max<std::size_t>(1, (beams + most - 1) / most);
}

std::string pack_beams(std::size_t lidar, const LaserScan& scan, std::size_t stride) {
  std::string block;
  append_varint(block, lidar);
  std::int64_t last = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); i += stride) {
    const double range = scan.ranges[i];
    const bool hit = std::isfinite(range) && range >= 0.0;
    const std::int64_t value = hit ? quantize(range, kRecordingPoint) + 1 : 0;
    append_signed(block, value - last);
    last = value;
  }
  return block;
}

std::string pack_populations(const std::vector<PopulationView>& populations, std::size_t most,
                             bool heights) {
  std::string block;
  append_varint(block, populations.size());
  const std::size_t each =
      std::max<std::size_t>(8, most / std::max<std::size_t>(1, populations.size()));
  for (const PopulationView& population : populations) {
    append_population(block, population, each, heights);
  }
  return block;
}

std::string pack_people(const std::vector<PersonTruth>& people) {
  std::string block;
  append_varint(block, people.size());
  for (const PersonTruth& person : people) {
    append_signed(block, person.id);
    append_pose(block, person.T_map_person);
  }
  return block;
}

}  // namespace castaway::testbed
