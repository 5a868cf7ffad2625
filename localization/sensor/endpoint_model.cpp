#include "localization/sensor/endpoint_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "localization/sensor/pose_in_cells.hpp"

namespace castaway::localization {
namespace {

/// Calls `take` with the field's value at each point, in their order.
template <typename Take>
[[gnu::always_inline]] inline void look_up_cells(const InterpolatedField& field,
                                                 const PoseInCells& pose, const ScanPoints& points,
                                                 const Take& take) {
  std::size_t i = 0;
  for (; i + 4 <= points.size(); i += 4) {
    const FourFloats px = load_four(&points.x[i]);
    const FourFloats py = load_four(&points.y[i]);
    const FourFloats values = field.at_cells(pose.x(px, py), pose.y(px, py));
    for (int k = 0; k < 4; ++k) take(values[k]);
  }
  for (; i < points.size(); ++i) {
    take(field.at_cells(pose.x(points.x[i], points.y[i]), pose.y(points.x[i], points.y[i])));
  }
}

/// The same in space. Cells are found some points ahead, so that memory is read meanwhile.
template <typename Take>
void look_up_surfaces(const SurfaceField& surfaces, const SurfaceField::Table& values,
                      const Eigen::Isometry3d& T_map_base, const ScanPoints& points,
                      const Take& take) {
  constexpr std::size_t kAhead = 8;
  std::array<SurfaceField::FourCells, kAhead> found;
  const SurfaceField::LatticePose pose = surfaces.lattice_pose(T_map_base);
  for (std::size_t first = 0; first < points.size(); first += 4 * kAhead) {
    const std::size_t count = std::min(4 * kAhead, points.size() - first);
    for (std::size_t i = 0; i < count; i += 4) {
      const FourPoints p = transform(pose.R, pose.t, four_ends(points, first + i));
      found[i / 4] = surfaces.find(p.x, p.y, p.z);
    }
    std::size_t i = 0;
    for (; i + 4 <= count; i += 4) {
      const FourInts places = surfaces.table_places(found[i / 4]);
      for (int k = 0; k < 4; ++k) take(values[static_cast<std::size_t>(places[k])]);
    }
    if (i == count) continue;
    const FourInts places = surfaces.table_places(found[i / 4]);
    for (int k = 0; i < count; ++i, ++k) take(values[static_cast<std::size_t>(places[k])]);
  }
}

}  // namespace

void validate(const EndpointConfig& config) {
  if (!(config.sigma > 0.0)) throw std::invalid_argument("sigma must be positive");
  if (!(config.floor > 0.0)) throw std::invalid_argument("floor must be positive");
  if (!(config.independent_beams > 0.0)) {
    throw std::invalid_argument("independent_beams must be positive");
  }
}

double endpoint_log_likelihood(const EndpointConfig& config, double distance) {
  const double z = distance / config.sigma;
  return std::log(std::exp(-0.5 * z * z) + config.floor) - std::log1p(config.floor);
}

EndpointModel::EndpointModel(const EndpointConfig& config, const DistanceField& distances)
    : config_((validate(config), config)),
      field_(PlanarField{{distances, [&](double d) { return endpoint_log_likelihood(config, d); }},
                         MapToGrid(distances.frame())}) {}

EndpointModel::EndpointModel(const EndpointConfig& config, const Volume& volume)
    : config_((validate(config), config)),
      field_(VolumeField{&volume, volume.surfaces().tabulate([&](double d) {
                           return endpoint_log_likelihood(config, d);
                         })}) {}

const GridFrame& EndpointModel::frame() const {
  const auto* planar = std::get_if<PlanarField>(&field_);
  return planar != nullptr ? planar->values.frame()
                           : std::get<VolumeField>(field_).volume->atlas().frame();
}

template <typename Take>
void EndpointModel::look_up(const ScanPoints& points, const SE2& T_map_base,
                            const Take& take) const {
  if (const auto* planar = std::get_if<PlanarField>(&field_)) {
    return look_up_cells(planar->values, PoseInCells(planar->to_grid, T_map_base), points, take);
  }
  const auto& [volume, values] = std::get<VolumeField>(field_);
  const auto base = volume->lift(T_map_base);
  if (!base) {
    for (std::size_t i = 0; i < points.size(); ++i) take(values.back());
    return;
  }
  look_up_surfaces(volume->surfaces(), values, base->T_map_base, points, take);
}

double EndpointModel::log_likelihood(const ScanPoints& points, const SE2& T_map_base) const {
  if (points.empty()) return 0.0;
  float sum = 0.0F;
  look_up(points, T_map_base, [&sum](float value) { sum += value; });
  return config_.independent_beams * static_cast<double>(sum) / static_cast<double>(points.size());
}

std::vector<float> EndpointModel::beam_log_likelihoods(const ScanPoints& points,
                                                       const SE2& T_map_base) const {
  std::vector<float> result;
  result.reserve(points.size());
  look_up(points, T_map_base, [&result](float value) { result.push_back(value); });
  return result;
}

}  // namespace castaway::localization
