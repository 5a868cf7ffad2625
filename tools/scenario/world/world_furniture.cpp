// Furniture of world files, built from several boxes.
#include "tools/scenario/world/object_reader.hpp"

namespace castaway::testbed {
namespace {

constexpr double kTableTop = 0.03;    // [m] Thickness.
constexpr double kSeatHeight = 0.45;  // [m]
constexpr double kBoard = 0.03;       // [m] Thickness of a shelf's boards.

/// Adds legs at the corners of a rectangle.
void add_legs(const Eigen::Isometry3d& T, const Eigen::Vector3d& room, double leg, Bodies& out) {
  for (const double side_x : {-0.5, 0.5}) {
    for (const double side_y : {-0.5, 0.5}) {
      out.bodies.push_back(box_at(T, {side_x * (room.x() - leg), side_y * (room.y() - leg), 0.0},
                                  {leg, leg, room.z()}));
    }
  }
}

}  // namespace

Bodies read_table(YamlReader& reader) {
  const Eigen::Vector3d size = size_of(reader);
  const double leg = positive(reader, "leg", 0.05);
  const double height = size.z() - kTableTop;
  if (height <= 0.0) reader.find("size")->fail("a table is higher than its top of 0.03 m");
  const Eigen::Isometry3d T = floor_frame(reader);
  Bodies table{{box_at(T, {0.0, 0.0, height}, {size.x(), size.y(), kTableTop})}, {}};
  add_legs(T, {size.x(), size.y(), height}, leg, table);
  return table;
}

Bodies read_chair(YamlReader& reader) {
  const auto size = reader.get<Eigen::Vector3d>("size", Eigen::Vector3d(0.45, 0.45, 0.9));
  if (size.head<2>().minCoeff() <= 0.1 || size.z() <= kSeatHeight || size.maxCoeff() > 5.0) {
    reader.find("size")->fail("a chair is deeper and wider than 0.1 m and higher than 0.45 m");
  }
  const Eigen::Isometry3d T = floor_frame(reader);
  const double leg = 0.035;
  Bodies chair{{box_at(T, {0.0, 0.0, kSeatHeight - 0.04}, {size.x(), size.y(), 0.04})}, {}};
  add_legs(T, {size.x(), size.y(), kSeatHeight - 0.04}, leg, chair);
  chair.bodies.push_back(box_at(T, {-0.5 * (size.x() - leg), 0.0, kSeatHeight},
                                {leg, size.y(), size.z() - kSeatHeight}));
  return chair;
}

Bodies read_shelf(YamlReader& reader) {
  const Eigen::Vector3d size = size_of(reader);
  const double post = positive(reader, "post", 0.08);
  const int levels = reader.get("levels", 3);
  if (levels < 1 || levels > 20) reader.find("levels")->fail("a shelf has 1 to 20 levels");
  const double first = positive(reader, "first", 0.15);
  if (first + kBoard > size.z()) reader.find("first")->fail("the lowest board is above the top");
  const Eigen::Isometry3d T = floor_frame(reader);
  Bodies shelf;
  add_legs(T, size, post, shelf);
  const double step = levels > 1 ? (size.z() - kBoard - first) / (levels - 1) : 0.0;
  for (int level = 0; level < levels; ++level) {
    shelf.bodies.push_back(
        box_at(T, {0.0, 0.0, first + level * step}, {size.x(), size.y(), kBoard}));
  }
  return shelf;
}

}  // namespace castaway::testbed
