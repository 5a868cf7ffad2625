#include "localization/paper/rays_at_yaw.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "localization/map/cell_index.hpp"

namespace castaway::localization {
namespace {

SE2 pose_at(const GridFrame& frame, const Eigen::Vector2i& cell, double yaw_map) {
  const Eigen::Vector2d p = frame.T_map_grid * frame.centre_of(cell);
  return {p.x(), p.y(), yaw_map};
}

float sum_of_sizes(float a, float b) { return std::abs(a) + std::abs(b); }

/// True if a coordinate lies farther than the margin from the borders of its cell.
bool is_inside(float coordinate, float margin) {
  return cell_index(coordinate - margin) == cell_index(coordinate + margin);
}

}  // namespace

/// A beam for base in cell (0, 0), in cells.
struct RaysAtYaw::Ray {
  float x, y;    ///< End point.
  float dx, dy;  ///< From the origin to the end point.
  float error;   ///< Bound of the rounding errors of x and y, here and at any other cell.

  Ray(const RayLocalModel& model, const PoseInCells& pose, const ScanPoints& points, std::size_t i)
      : x(pose.x(points.x[i], points.y[i])),
        y(pose.y(points.x[i], points.y[i])),
        dx(x - pose.x(points.origin_x[i], points.origin_y[i])),
        dy(y - pose.y(points.origin_x[i], points.origin_y[i])) {
    const float largest = 2.0F * (sum_of_sizes(x, y) + sum_of_sizes(dx, dy)) + 4.0F;
    error = 0x1p-20F * (reach(model) + largest);
  }
  /// Points farther away lie off the map from all cells.
  static float reach(const RayLocalModel& model) {
    return static_cast<float>(model.frame().width + model.frame().height + model.walls().cap());
  }
};

RaysAtYaw::RaysAtYaw(const RayLocalModel& model, const ScanPoints& points, double yaw_map)
    : model_(&model), points_(&points), yaw_map_(yaw_map) {
  const PoseInCells pose(model.frame(), pose_at(model.frame(), {0, 0}, yaw_map));
  const float reach = Ray::reach(model);
  for (std::size_t beam = 0; beam < points.size(); ++beam) {
    const Ray ray(model, pose, points, beam);
    const bool near = std::abs(ray.x) < reach && std::abs(ray.y) < reach;
    if (near) add_ends(ray);
    certain_.push_back(near ? 1 : 0);
    add_probes(ray);
  }
}

void RaysAtYaw::add_ends(const Ray& ray) {
  for (int row = cell_index(ray.y - ray.error); row <= cell_index(ray.y + ray.error); ++row) {
    const int last = cell_index(ray.x + ray.error);
    for (int column = cell_index(ray.x - ray.error); column <= last; ++column) {
      ends_.push_back({column, row});
    }
  }
}

void RaysAtYaw::add_probes(const Ray& ray) {
  const float length = std::max(std::hypot(ray.dx, ray.dy), 1e-6F);
  const auto add = [&](float cells) {
    const float x = ray.x + cells / length * ray.dx;
    const float y = ray.y + cells / length * ray.dy;
    // The direction is the less certain the shorter the beam.
    const float margin = ray.error * (1.0F + 8.0F * std::abs(cells) / length);
    if (!is_inside(x, margin) || !is_inside(y, margin)) certain_.back() = 0;
    probes_.push_back({cell_index(x), cell_index(y)});
  };
  add(0.0F);
  for (std::size_t k = 1; k < model_->no_wall(); ++k) {
    add(static_cast<float>(k));
    add(-static_cast<float>(k));
  }
}

/// Number of cells from the end point of a beam to the nearest wall, if all probes are certain.
std::size_t RaysAtYaw::error_cells(std::size_t beam, const Eigen::Vector2i& cell) const {
  const std::size_t none = model_->no_wall();
  const CellOffset* probes = probes_.data() + beam * (2 * none - 1);
  const auto distance = [&](const CellOffset& probe) {
    return model_->walls().at(cell.x() + probe.dx, cell.y() + probe.dy);
  };
  // Probe k lies at most k columns and rows away.
  auto k = static_cast<std::size_t>(distance(probes[0]));
  if (k == 0) return 0;
  for (; k < none; ++k) {
    if (distance(probes[2 * k - 1]) == 0 || distance(probes[2 * k]) == 0) return k;
  }
  return none;
}

double RaysAtYaw::hits(const Eigen::Vector2i& cell) const {
  std::optional<PoseInCells> pose;
  double hits = 0.0;
  for (std::size_t beam = 0; beam < certain_.size(); ++beam) {
    if (certain_[beam] != 0) {
      hits += model_->hits_at(error_cells(beam, cell));
      continue;
    }
    if (!pose) pose.emplace(model_->frame(), pose_at(model_->frame(), cell, yaw_map_));
    hits += model_->hits_at(model_->error_cells(*points_, beam, *pose));
  }
  return hits;
}

}  // namespace castaway::localization
