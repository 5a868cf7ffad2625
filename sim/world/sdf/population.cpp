#include "sim/world/sdf/population.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "sim/common/xml_pose.hpp"

namespace castaway::sim {
namespace {

using PointList = std::vector<Eigen::Vector3d>;

constexpr double kMostModels = 20000;
constexpr double kSampleSpacing = 0.1;  // [m] Of the samples of a box.
constexpr double kMostSamples = 10000;  // Number that Gazebo draws in a cylinder.
constexpr double kMostDistances = 2e8;  // That are computed to find clusters.
constexpr int kMostRounds = 100;

[[noreturn]] void refuse_population(const std::string& why) {
  throw std::runtime_error("its " + why);
}

const TiXmlElement& required_child(const TiXmlElement& parent, const char* name) {
  const TiXmlElement* child = parent.FirstChildElement(name);
  if (child == nullptr) refuse_population(fmt::format("population has no <{}>", name));
  return *child;
}

/// A number of models, rows or columns.
int count_of(const TiXmlElement& parent, const char* name) {
  const double count = child_vector(parent, name).x();
  if (count < 1.0 || count > kMostModels) {
    refuse_population(fmt::format("<{}> is {}: a number from 1 to {}", name, count, kMostModels));
  }
  return static_cast<int>(count);
}

double length_of(double length, const char* name) {
  if (!(length > 0.0)) refuse_population(fmt::format("<{}> is {}: a number above 0", name, length));
  return length;
}

/// What is populated.
struct Region {
  bool box = true;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< [m] Of a box.
  double radius = 0.0;                             ///< [m] Of a cylinder.
  double height = 0.0;                             ///< [m] Of a cylinder.
};

Region region_of(const TiXmlElement& population) {
  Region region;
  if (const TiXmlElement* box = population.FirstChildElement("box")) {
    region.size = child_vector(*box, "size");
    length_of(region.size.minCoeff(), "size");
    return region;
  }
  const TiXmlElement& cylinder = required_child(population, "cylinder");
  region.box = false;
  region.radius = length_of(child_vector(cylinder, "radius").x(), "radius");
  region.height = length_of(child_vector(cylinder, "length").x(), "length");
  return region;
}

Eigen::Vector3d draw_in(const Region& region, Rng& rng) {
  if (region.box) {
    const double x = draw_between(0.0, region.size.x(), rng);
    const double y = draw_between(0.0, region.size.y(), rng);
    return {x, y, draw_between(0.0, region.size.z(), rng)};
  }
  const double angle = draw_between(0.0, 2.0 * std::numbers::pi, rng);
  const double r = draw_between(0.0, region.radius, rng);
  return {r * std::cos(angle), r * std::sin(angle), draw_between(0.0, region.height, rng)};
}

PointList draw_points(const Region& region, int count, Rng& rng) {
  PointList points;
  for (int i = 0; i < count; ++i) points.push_back(draw_in(region, rng));
  return points;
}

/// Samples over a region: in a box on a lattice of columns, in a cylinder at random.
PointList samples_of(const Region& region, Rng& rng) {
  if (!region.box) return draw_points(region, static_cast<int>(kMostSamples), rng);
  const double area = region.size.x() * region.size.y();
  const double spacing = std::max(kSampleSpacing, std::sqrt(area / kMostSamples));
  PointList points;
  for (double y = 0.0; y < region.size.y(); y += spacing) {
    for (double x = 0.0; x < region.size.x(); x += spacing) {
      points.emplace_back(x, y, draw_between(0.0, region.size.z(), rng));
      if (static_cast<double>(points.size()) > 2.0 * kMostSamples) return points;
    }
  }
  return points;
}

std::size_t nearest(const PointList& centers, const Eigen::Vector3d& p) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const double distance = (centers[i] - p).squaredNorm();
    if (distance < least) std::tie(best, least) = std::pair(i, distance);
  }
  return best;
}

/// The mean of each centre's samples; of no samples: the centre.
PointList means_of(const PointList& samples, const PointList& centers) {
  PointList sums(centers.size(), Eigen::Vector3d::Zero());
  std::vector<double> counts(centers.size(), 0.0);
  for (const Eigen::Vector3d& p : samples) {
    const std::size_t i = nearest(centers, p);
    sums[i] += p;
    counts[i] += 1.0;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = counts[i] > 0.0 ? Eigen::Vector3d(sums[i] / counts[i]) : centers[i];
  }
  return sums;
}

/// Centres of clusters by Lloyd's algorithm from random samples.
PointList cluster(PointList samples, int count, Rng& rng) {
  const auto n = static_cast<std::size_t>(count);
  if (samples.size() < n)
    refuse_population(fmt::format("region is too small for {} models", count));
  const PointList all = samples;
  for (std::size_t i = 0; i < n; ++i) {
    const double left = static_cast<double>(samples.size() - i);
    std::swap(samples[i], samples[i + static_cast<std::size_t>(draw_between(0.0, left, rng))]);
  }
  PointList centers(samples.begin(), samples.begin() + count);
  const double each = static_cast<double>(all.size()) * count;
  const int rounds = std::clamp(static_cast<int>(kMostDistances / each), 1, kMostRounds);
  for (int round = 0; round < rounds; ++round) {
    PointList next = means_of(all, centers);
    if (next == centers) break;
    centers = std::move(next);
  }
  return centers;
}

/// Places in a row along an axis, in the middle of the others.
PointList row_of(const Region& region, int count, int axis) {
  PointList points;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d p = 0.5 * region.size;
    p[axis] = region.size[axis] * i / count;
    points.push_back(p);
  }
  return points;
}

PointList grid_of(int rows, int columns, const Eigen::Vector3d& step) {
  PointList points;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      points.emplace_back(column * step.x(), row * step.y(), 0.0);
    }
  }
  return points;
}

/// Adds the pose of the population, whose origin is shifted.
PopulationPlaces placed(PointList points, const TiXmlElement& population,
                        const Eigen::Vector3d& shift, bool drawn) {
  const Eigen::Isometry3d T = child_pose(population);
  for (Eigen::Vector3d& p : points) p = T.linear() * p + T.translation() + shift;
  return {std::move(points), drawn};
}

PopulationPlaces place_grid(const TiXmlElement& population, const TiXmlElement& distribution) {
  const int rows = count_of(distribution, "rows");
  const int columns = count_of(distribution, "cols");
  if (rows * static_cast<double>(columns) > kMostModels) {
    refuse_population(
        fmt::format("grid has {} x {} models: at most {}", rows, columns, kMostModels));
  }
  const Eigen::Vector3d step = child_vector(required_child(population, "distribution"), "step");
  const Eigen::Vector3d shift(-0.5 * (columns - 1) * step.x(), -0.5 * (rows - 1) * step.y(), 0.0);
  return placed(grid_of(rows, columns, step), population, shift, false);
}

}  // namespace

PopulationPlaces place_population(const TiXmlElement& population, Rng& rng) {
  const TiXmlElement& distribution = required_child(population, "distribution");
  const std::string type = child_text(distribution, "type");
  if (type == "grid") return place_grid(population, distribution);
  const Region region = region_of(population);
  const int count = count_of(population, "model_count");
  const Eigen::Vector3d shift = -0.5 * region.size;  // Of a cylinder: none.
  if (type == "random") {
    return placed(draw_points(region, count, rng), population, shift, true);
  }
  if (type == "uniform") {
    return placed(cluster(samples_of(region, rng), count, rng), population, shift, true);
  }
  static const std::map<std::string, int> axes{{"linear-x", 0}, {"linear-y", 1}, {"linear-z", 2}};
  const auto axis = axes.find(type);
  if (axis == axes.end() || !region.box) {
    refuse_population(fmt::format("distribution '{}' over a {} is none of Gazebo's", type,
                                  region.box ? "box" : "cylinder"));
  }
  return placed(row_of(region, count, axis->second), population, shift, false);
}

}  // namespace castaway::sim
