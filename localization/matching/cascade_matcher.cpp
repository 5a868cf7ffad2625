#include "localization/matching/cascade_matcher.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace castaway::localization {
namespace {

constexpr int kBlock = 16;

/// Byte offsets of the end points at one yaw, relative to the cell in whose centre base stands.
std::vector<std::ptrdiff_t> offsets_at(const ScanPoints& points, const MatcherConfig& config,
                                       const ByteField& field, double yaw_grid) {
  const std::size_t wanted = std::min(points.size(), static_cast<std::size_t>(config.points));
  const double c = std::cos(yaw_grid) / field.frame().resolution;
  const double s = std::sin(yaw_grid) / field.frame().resolution;
  std::vector<std::ptrdiff_t> offsets;
  offsets.reserve(wanted);
  for (std::size_t k = 0; k < wanted; ++k) {
    const std::size_t i = k * points.size() / wanted;
    const double px = points.x[i];
    const double py = points.y[i];
    const int dx = static_cast<int>(std::floor(0.5 + c * px - s * py));
    const int dy = static_cast<int>(std::floor(0.5 + s * px + c * py));
    if (std::max(std::abs(dx), std::abs(dy)) >= field.padding()) continue;
    offsets.push_back(dy * field.stride() + dx);
  }
  return offsets;
}

/// Sums of the bytes of 16 neighbouring places.
std::array<std::uint16_t, kBlock> block_sums(const std::uint8_t* base,
                                             const std::vector<std::ptrdiff_t>& offsets) {
  std::array<std::uint16_t, kBlock> sums{};
  for (const std::ptrdiff_t offset : offsets) {
    const std::uint8_t* bytes = base + offset;
    for (std::size_t j = 0; j < kBlock; ++j) {
      sums[j] = static_cast<std::uint16_t>(sums[j] + bytes[j]);
    }
  }
  return sums;
}

/// The best place of every neighbourhood.
class BestPerBin {
 public:
  BestPerBin(const GridFrame& frame, const MatcherConfig& config, int yaws)
      : cells_(std::max(1, static_cast<int>(config.suppression_m / frame.resolution))),
        yaws_(std::max(1, static_cast<int>(std::lround(config.suppression_rad * yaws /
                                                       (2.0 * std::numbers::pi))))),
        columns_(frame.width / cells_ + 1),
        rows_(frame.height / cells_ + 1),
        bins_(static_cast<std::size_t>(columns_ * rows_ * (yaws / yaws_ + 1))) {}

  struct Place {
    int column = 0, row = 0, yaw = 0;
    std::uint16_t score = 0;
  };

  void offer(const Place& place) {
    const int bin =
        ((place.yaw / yaws_) * rows_ + place.row / cells_) * columns_ + place.column / cells_;
    Place& best = bins_[static_cast<std::size_t>(bin)];
    if (place.score > best.score) best = place;
  }

  /// The best `count` bins, best first; ties in order of the bins.
  [[nodiscard]] std::vector<Place> best(std::size_t count) const {
    std::vector<Place> places;
    std::copy_if(bins_.begin(), bins_.end(), std::back_inserter(places),
                 [](const Place& p) { return p.score > 0; });
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.score > b.score; });
    places.resize(std::min(places.size(), count));
    return places;
  }

 private:
  int cells_, yaws_, columns_, rows_;
  std::vector<Place> bins_;
};

}  // namespace

void validate(const MatcherConfig& config) {
  if (config.points < 1 || config.points > 256) {
    throw std::invalid_argument("matcher points must be in 1..256");
  }
  if (!(config.yaw_step > 0.0)) throw std::invalid_argument("matcher yaw_step must be positive");
  if (config.candidates < 1) throw std::invalid_argument("matcher candidates must be at least 1");
}

CascadeMatcher::CascadeMatcher(const MatcherConfig& config, const OccupancyGrid& grid,
                               const DistanceField& distances)
    : config_((validate(config), config)),
      field_(grid, distances, config.field),
      yaws_(std::max(1, static_cast<int>(std::lround(2.0 * std::numbers::pi / config.yaw_step)))) {
  const GridFrame& frame = field_.frame();
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; column += kBlock) {
      Block block{column, row, 0};
      for (int j = 0; j < kBlock && column + j < frame.width; ++j) {
        if (field_.is_free(column + j, row)) {
          block.free = static_cast<std::uint16_t>(block.free | (1U << static_cast<unsigned>(j)));
        }
      }
      if (block.free != 0) blocks_.push_back(block);
    }
  }
}

std::vector<CascadeMatcher::Block> CascadeMatcher::blocks_within(
    const std::optional<MatchWindow>& window) const {
  if (!window) return blocks_;
  const GridFrame& frame = field_.frame();
  const Eigen::Vector2d centre = frame.T_map_grid.inverse() * window->centre.translation();
  const Eigen::Vector2i low = frame.cell_of(centre.array() - window->radius);
  const Eigen::Vector2i high = frame.cell_of(centre.array() + window->radius);
  std::vector<Block> within;
  for (Block block : blocks_) {
    if (block.row < low.y() || block.row > high.y()) continue;
    for (int j = 0; j < kBlock; ++j) {
      const int column = block.column + j;
      if (column >= low.x() && column <= high.x()) continue;
      block.free = static_cast<std::uint16_t>(block.free & ~(1U << static_cast<unsigned>(j)));
    }
    if (block.free != 0) within.push_back(block);
  }
  return within;
}

std::vector<Candidate> CascadeMatcher::match(const ScanPoints& points,
                                             const std::optional<MatchWindow>& window) const {
  if (points.empty()) return {};
  const GridFrame& frame = field_.frame();
  const std::vector<Block> blocks = blocks_within(window);
  BestPerBin best(frame, config_, yaws_);
  for (int k = 0; k < yaws_; ++k) {
    const double yaw = 2.0 * std::numbers::pi * k / yaws_;
    const double yaw_map = yaw + frame.T_map_grid.yaw;
    if (window && std::abs(wrap_angle(yaw_map - window->centre.yaw)) > window->yaw_radius) continue;
    const std::vector<std::ptrdiff_t> offsets = offsets_at(points, config_, field_, yaw);
    for (const Block& block : blocks) {
      const auto sums = block_sums(field_.cell(block.column, block.row), offsets);
      for (int j = 0; j < kBlock; ++j) {
        if ((block.free >> static_cast<unsigned>(j) & 1U) == 0) continue;
        best.offer({block.column + j, block.row, k, sums[static_cast<std::size_t>(j)]});
      }
    }
  }
  const double perfect =
      255.0 * std::min<double>(config_.points, static_cast<double>(points.size()));
  std::vector<Candidate> candidates;
  for (const auto& place : best.best(static_cast<std::size_t>(config_.candidates))) {
    const Eigen::Vector2d p = frame.centre_of({place.column, place.row});
    const SE2 T_grid_base{p.x(), p.y(), wrap_angle(2.0 * std::numbers::pi * place.yaw / yaws_)};
    candidates.push_back({frame.T_map_grid * T_grid_base, place.score / perfect});
  }
  return candidates;
}

}  // namespace castaway::localization
