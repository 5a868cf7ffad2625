#include "tools/batch/trials/office_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "localization/geometry/random.hpp"
#include "sim/common/random.hpp"

namespace castaway::testbed {
namespace {

constexpr double kWall = 0.15;       // [m] Thickness.
constexpr double kCorridor = 2.0;    // [m] Width.
constexpr double kBand = 10.0;       // [m] Approximate height of a band: a corridor and the rooms
                                     // on both sides.
constexpr double kRoom = 4.8;        // [m] Approximate width of a room including one wall.
constexpr double kFirstLink = 14.0;  // [m] x of the first cross corridor.
constexpr double kLinks = 40.0;      // [m] Distance between cross corridors.
constexpr double kDoor = 0.9;        // [m]

constexpr std::int8_t kFree = 0;
constexpr std::int8_t kOccupied = 100;

/// A rectangle [m].
struct Box {
  double x0 = 0.0;
  double y0 = 0.0;
  double x1 = 0.0;
  double y1 = 0.0;
};

/// Draws corridors, rooms and furniture into a map that is initially all wall.
class OfficeBuilder {
 public:
  explicit OfficeBuilder(const OfficeSpec& spec)
      : spec_(spec), rng_(localization::substream(spec.seed, "office")) {
    map_.name = "office";
    map_.resolution = spec.resolution;
    map_.width = static_cast<int>(std::lround(spec.width / spec.resolution));
    map_.height = static_cast<int>(std::lround(spec.height / spec.resolution));
    map_.cells.assign(static_cast<std::size_t>(map_.width) * static_cast<std::size_t>(map_.height),
                      kOccupied);
  }

  RosMap draw() {
    const int bands = std::max(1, static_cast<int>(std::lround(spec_.height / kBand)));
    const double pitch = spec_.height / bands;
    for (int band = 0; band < bands; ++band) {
      const double top = band + 1 == bands ? spec_.height - kWall : (band + 1) * pitch;
      draw_band(band * pitch + kWall, (band + 0.5) * pitch, top);
    }
    for (double x = kFirstLink; x < spec_.width - kRoom; x += kLinks) {
      fill({x, kWall, x + kCorridor, spec_.height - kWall}, kFree);
    }
    return std::move(map_);
  }

 private:
  /// Draws a corridor around y = `middle` and its rooms from `bottom` to `top`.
  void draw_band(double bottom, double middle, double top) {
    const double low = middle - 0.5 * kCorridor;
    const double high = middle + 0.5 * kCorridor;
    fill({kWall, low, spec_.width - kWall, high}, kFree);
    for (double left = 0.0; left < spec_.width - kRoom;) {
      const double link = next_link(left);
      const double right = std::min(link, spec_.width) - kWall;
      const int rooms = std::max(1, static_cast<int>(std::lround((right - left) / kRoom)));
      const double pitch = (right - left) / rooms;
      for (int i = 0; i < rooms; ++i) {
        const double x0 = left + i * pitch + kWall;
        draw_room({x0, bottom, left + (i + 1) * pitch, low - kWall}, true);
        draw_room({x0, high + kWall, left + (i + 1) * pitch, top}, false);
      }
      left = link + kCorridor;
    }
  }

  [[nodiscard]] double next_link(double x) const {
    const double link = kFirstLink + kLinks * std::ceil((x - kFirstLink) / kLinks);
    return link < spec_.width - kRoom ? link : spec_.width;
  }

  /// Draws a room; its door and its cabinet are on the corridor's side.
  void draw_room(const Box& room, bool door_above) {
    const double wall = door_above ? room.y1 : room.y0 - kWall;
    fill(room, kFree);
    const double door = room.x0 + 0.5 + between(0.0, 0.6);
    fill({door, wall, door + kDoor, wall + kWall}, kFree);
    furnish(room, door_above);
    if (between(0.0, 1.0) > 0.4) return;
    const double x = door + kDoor + between(0.5, 1.2);
    const double y = door_above ? wall + kWall : wall - 0.4;
    fill({x, y, x + between(0.5, 1.2), y + 0.4}, kOccupied);
  }

  /// Places desks by the far wall and a cupboard at the right wall.
  void furnish(const Box& room, bool door_above) {
    const auto place = [&](double x, double from_far, double width, double depth) {
      const double y = door_above ? room.y0 + from_far : room.y1 - from_far - depth;
      fill({x, y, x + width, y + depth}, kOccupied);
    };
    place(room.x0 + between(0.4, 1.4), between(0.3, 0.7), between(1.2, 1.6), 0.7);
    if (between(0.0, 1.0) < 0.5) place(room.x1 - 1.6, between(0.2, 0.5), between(0.7, 1.0), 0.6);
    place(room.x1 - between(0.35, 0.5), between(1.6, 2.2), 0.5, between(0.8, 1.2));
  }

  /// Fills the cells whose centres lie in a rectangle; the part outside the map is ignored.
  void fill(const Box& box, std::int8_t value) {
    const auto first = [&](double v) {
      return std::max(0, static_cast<int>(std::ceil(v / spec_.resolution - 0.5)));
    };
    for (int row = first(box.y0); row < std::min(first(box.y1), map_.height); ++row) {
      for (int column = first(box.x0); column < std::min(first(box.x1), map_.width); ++column) {
        map_.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.width) +
                   static_cast<std::size_t>(column)] = value;
      }
    }
  }

  double between(double low, double high) { return sim::draw_between(low, high, rng_); }

  OfficeSpec spec_;
  localization::Rng rng_;
  RosMap map_;
};

}  // namespace

RosMap draw_office(const OfficeSpec& spec) {
  if (!(spec.width >= 10.0) || !(spec.height >= 10.0)) {
    throw std::invalid_argument("an office is at least 10 x 10 m");
  }
  if (!(spec.resolution > 0.0) || spec.resolution > 0.1) {
    throw std::invalid_argument("an office's resolution must be in (0, 0.1] m");
  }
  return OfficeBuilder(spec).draw();
}

}  // namespace castaway::testbed
