#include "sim/world/floor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/world/footprint.hpp"
#include "sim/world/world_visuals.hpp"

namespace castaway::sim {
namespace {

constexpr double kHeadroom = 0.4;    // [m] Free height that a robot needs above a level.
constexpr double kSameLevel = 0.02;  // [m]
constexpr double kLevelArea = 2.0;   // [m^2] Level faces with less area are furniture.
constexpr double kMostlyUp = 0.9;  // Least z component of the unit normal of a face that faces up.
constexpr double kAroundStart = 0.3;  // [m] The wheels need the level around the start, too.
constexpr double kStage = 0.35;       // [m] Levels this high above a large ground are furniture.
constexpr double kMuchGround = 0.2;   // Share of the extent that makes a ground large.
constexpr double kRises = 0.05;       // [m]
constexpr int kAcross = 48;           // Number of columns along either side of the extent.

/// Intersection of a vertical line with a face.
struct Crossing {
  double z = 0.0;
  bool up = false;      ///< The face is level and faces up.
  bool enters = false;  ///< The line, going down, enters a body here; false: it leaves one.
  bool solid = false;   ///< The body is certainly closed.
};

struct Column {
  Eigen::Vector2d p = Eigen::Vector2d::Zero();
  std::vector<Crossing> crossings;
};

/// A triangle in map.
struct Face {
  Eigen::Vector3d a, b, c, normal;
  double area = 0.0;  ///< [m^2] Of its horizontal projection.
};

Face face_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d n = (b - a).cross(c - a);
  return {a, b, c, n.normalized(), 0.5 * std::abs(n.z())};
}

/// Height of a face above a point of the plane; nothing if the point is beside it.
std::optional<double> height_at(const Face& f, const Eigen::Vector2d& p) {
  const Eigen::Vector2d ab = (f.b - f.a).head<2>();
  const Eigen::Vector2d ac = (f.c - f.a).head<2>();
  const Eigen::Vector2d ap = p - f.a.head<2>();
  const double twice = ab.x() * ac.y() - ab.y() * ac.x();
  if (twice == 0.0) return std::nullopt;
  const double u = (ap.x() * ac.y() - ap.y() * ac.x()) / twice;
  const double v = (ab.x() * ap.y() - ab.y() * ap.x()) / twice;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return std::nullopt;
  return f.a.z() + u * (f.b.z() - f.a.z()) + v * (f.c.z() - f.a.z());
}

/// Vertical lines through a world, and the area of its level faces by height.
class Levels {
 public:
  /// `columns`: sorted by x.
  explicit Levels(std::vector<Column> columns) : columns_(std::move(columns)) {
    for (const Column& column : columns_) box_.extend(column.p);
  }

  void add(const WorldObject& object) {
    const TriangleMesh mesh = shape_mesh(object.shape);
    const bool solid = !std::holds_alternative<MeshShape>(object.shape);
    const auto vertex = [&](std::size_t i) -> Eigen::Vector3d {
      return object.T_map_object * mesh.vertices[mesh.indices[i]].cast<double>();
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      add(face_of(vertex(i), vertex(i + 1), vertex(i + 2)), solid);
    }
  }

  void add(const Ground& ground) {
    for (Column& column : columns_) {
      if (!ground.extent.isEmpty() && !ground.extent.contains(column.p)) continue;
      column.crossings.push_back({ground.height, true, true, false});
    }
  }

  /// The lowest level of each column, `base` if it has none; sorted.
  [[nodiscard]] std::vector<double> lowest(double base) {
    std::vector<double> levels;
    for (Column& column : columns_) levels.push_back(lowest_of(column).value_or(base));
    std::sort(levels.begin(), levels.end());
    return levels;
  }

  /// Area of all level faces near a height. [m^2]
  [[nodiscard]] double area_at(double height) const {
    double area = 0.0;
    for (const auto& [z, size] : level_faces_) {
      if (std::abs(z - height) <= kSameLevel) area += size;
    }
    return area;
  }

 private:
  void add(const Face& face, bool solid) {
    if (!(face.area > 0.0)) return;
    const bool up = face.normal.z() > kMostlyUp;
    if (up) level_faces_.emplace_back((face.a.z() + face.b.z() + face.c.z()) / 3.0, face.area);
    Eigen::AlignedBox2d seen;
    for (const Eigen::Vector3d& p : {face.a, face.b, face.c}) {
      seen.extend(Eigen::Vector2d(p.head<2>()));
    }
    if (!seen.intersects(box_)) return;
    auto column = std::lower_bound(columns_.begin(), columns_.end(), seen.min().x(),
                                   [](const Column& c, double x) { return c.p.x() < x; });
    for (; column != columns_.end() && column->p.x() <= seen.max().x(); ++column) {
      const auto z = height_at(face, column->p);
      if (z) column->crossings.push_back({*z, up, face.normal.z() > 0.0, solid});
    }
  }

  static std::optional<double> lowest_of(Column& column) {
    auto& crossings = column.crossings;
    std::stable_sort(crossings.begin(), crossings.end(),
                     [](const Crossing& a, const Crossing& b) { return a.z > b.z; });
    std::optional<double> lowest;
    std::optional<double> above;
    int depth = 0;
    for (const Crossing& crossing : crossings) {
      const bool room = !above || *above - crossing.z >= kHeadroom;
      if (crossing.up && depth == 0 && room) lowest = crossing.z;
      if (crossing.solid) depth = std::max(0, depth + (crossing.enters ? 1 : -1));
      above = crossing.z;
    }
    return lowest;
  }

  std::vector<Column> columns_;
  Eigen::AlignedBox2d box_;
  std::vector<std::pair<double, double>> level_faces_;  ///< Height [m], area [m^2].
};

std::vector<Column> columns_at(const Eigen::Vector2d& start) {
  std::vector<Column> columns;
  for (const double x : {-kAroundStart, 0.0, kAroundStart}) {
    for (const double y : {-kAroundStart, 0.0, kAroundStart}) {
      columns.push_back({start + Eigen::Vector2d(x, y), {}});
    }
  }
  return columns;
}

std::vector<Column> columns_over(const Eigen::AlignedBox2d& extent) {
  std::vector<Column> columns;
  for (int i = 0; i < kAcross; ++i) {
    for (int k = 0; k < kAcross; ++k) {
      const Eigen::Vector2d share((i + 0.5) / kAcross, (k + 0.5) / kAcross);
      columns.push_back({extent.min() + share.cwiseProduct(extent.sizes()), {}});
    }
  }
  return columns;
}

/// Centre of the interval of length `kSameLevel` with most values, and their number.
std::pair<double, std::size_t> most_common(const std::vector<double>& sorted) {
  std::pair<double, std::size_t> best{0.0, 0};
  for (std::size_t from = 0, to = 0; from < sorted.size(); ++from) {
    while (to < sorted.size() && sorted[to] - sorted[from] <= kSameLevel) ++to;
    if (to - from > best.second) best = {sorted[(from + to - 1) / 2], to - from};
  }
  return best;
}

Levels levels_of(const WorldSpec& world, const std::optional<Ground>& ground,
                 std::vector<Column> columns) {
  Levels levels(std::move(columns));
  for (const WorldObject& object : world.objects) {
    if (object.in_world) levels.add(object);
  }
  if (ground) levels.add(*ground);
  return levels;
}

Eigen::AlignedBox2d extent_of(const WorldSpec& world) {
  Eigen::AlignedBox2d extent;
  for (const WorldObject& object : world.objects) {
    const Eigen::AlignedBox3d box = bounds(object);
    extent.extend(Eigen::Vector2d(box.min().head<2>()));
    extent.extend(Eigen::Vector2d(box.max().head<2>()));
  }
  return extent;
}

/// Share of the columns whose level is near a height.
double share_at(const std::vector<double>& sorted, double height) {
  const auto count = std::count_if(sorted.begin(), sorted.end(), [&](double level) {
    return std::abs(level - height) <= kSameLevel;
  });
  return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, sorted.size()));
}

/// True if an object rises above a level; otherwise the level is no floor.
bool something_rises(const WorldSpec& world, double level) {
  return std::any_of(world.objects.begin(), world.objects.end(), [&](const WorldObject& object) {
    return bounds(object).max().z() > level + kRises;
  });
}

}  // namespace

double floor_height(const WorldSpec& world, const std::optional<Ground>& ground,
                    const std::optional<Eigen::Vector2d>& start) {
  const double base = ground ? ground->height : 0.0;
  if (world.objects.empty()) return base;
  Levels levels =
      levels_of(world, ground, start ? columns_at(*start) : columns_over(extent_of(world)));
  const std::vector<double> lowest = levels.lowest(base);
  const double level = most_common(lowest).first;
  const bool low = start || level - base < kStage || share_at(lowest, base) < kMuchGround;
  const bool large = level == base || levels.area_at(level) >= kLevelArea;
  return low && large && something_rises(world, level) ? level : base;
}

void settle(WorldSpec& world, double height) {
  for (WorldObject& object : world.objects) object.T_map_object.translation().z() -= height;
  for (Door& door : world.doors) door.T_map_hinge.translation().z() -= height;
  std::erase_if(world.objects,
                [](const WorldObject& object) { return bounds(object).max().z() <= kFloorTop; });
}

}  // namespace castaway::sim
