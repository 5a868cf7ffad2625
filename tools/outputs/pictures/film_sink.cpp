#include "tools/outputs/pictures/film_sink.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "tools/outputs/pictures/map_picture.hpp"

namespace castaway::testbed {
namespace {

constexpr double kInsetShare = 0.36;  // Maximum share of the film's width and of its height.
constexpr int kBorder = 2;            // [px]
constexpr int kMargin = 12;           // [px]

/// Aspect ratio of the map, limited.
double aspect_of(const RosMap& map) {
  return std::clamp(static_cast<double>(map.width) / std::max(1, map.height), 0.4, 2.5);
}

/// Width and height [px] of the inset for a map of this aspect ratio.
std::pair<int, int> inset_size(const FilmFormat& format, double aspect) {
  const double most_wide = kInsetShare * format.width;
  const double most_high = kInsetShare * format.height;
  const double wide = std::min(most_wide, most_high * aspect);
  return {std::max(16, static_cast<int>(wide)), std::max(16, static_cast<int>(wide / aspect))};
}

}  // namespace

void validate(const FilmConfig& config) {
  validate(config.format);
  if (!(config.speed > 0.0) || !std::isfinite(config.speed)) {
    throw std::invalid_argument(
        fmt::format("outputs.video.speed is {}; it must be above 0", config.speed));
  }
}

namespace {

bool contains(const sim::Image& image, int x, int y) {
  return x >= 0 && x < image.width && y >= 0 && y < image.height;
}

}  // namespace

void put_into_corner(const sim::Image& inset, sim::Image& image) {
  const int left = image.width - inset.width - kMargin;
  for (int y = -kBorder; y < inset.height + kBorder; ++y) {
    for (int x = -kBorder; x < inset.width + kBorder; ++x) {
      const int to_x = left + x;
      const int to_y = kMargin + y;
      if (!contains(image, to_x, to_y)) continue;
      const bool inside = contains(inset, x, y);
      for (int c = 0; c < 3; ++c) {
        const auto to = static_cast<std::size_t>(3 * (to_y * image.width + to_x) + c);
        const auto from = static_cast<std::size_t>(3 * (y * inset.width + x) + c);
        image.pixels[to] = inside ? inset.pixels[from] : std::uint8_t{40};
      }
    }
  }
}

FilmSink::FilmSink(const FilmConfig& config, PictureWorld world)
    : config_((validate(config), config)),
      world_(std::move(world)),
      renderer_(config.format.width, config.format.height),
      film_(config.format) {
  assert(world_.map || config_.view != FilmView::kMap);
  if (!world_.map) return;
  map_item_ = map_item(*world_.map);
  const auto [width, height] = inset_size(config.format, aspect_of(*world_.map));
  if (config_.view != FilmView::kMap) inset_.emplace(width, height);
}

void FilmSink::on_odometry(const OdometryFrame& frame) {
  const Stamp stamp = frame.odometry.stamp;
  if (!frame.true_pose || !newest_ || stamp < next_.value_or(stamp)) return;
  next_ = next_.value_or(stamp) + localization::from_seconds(config_.speed / config_.format.fps);
  take(frame.true_pose->T_map_base);
}

void FilmSink::take(const SE2& T_map_base) {
  ScanRecord now = *newest_;
  now.true_pose->T_map_base = T_map_base;
  any_ = true;
  if (config_.view == FilmView::kMap) {
    film_.add(map_picture(renderer_, world_, *map_item_, now));
    return;
  }
  sim::Image image = renderer_.render(config_.view == FilmView::kChase
                                          ? chase_scene(world_, *newest_, T_map_base)
                                          : overview_scene(world_, *newest_, T_map_base));
  if (inset_) {
    put_into_corner(map_picture(*inset_, world_, *map_item_, now), image);
  }
  film_.add(image);
}

void FilmSink::finish(Stamp, const RunTiming&) {
  if (any_) film_.commit();
}

}  // namespace castaway::testbed
