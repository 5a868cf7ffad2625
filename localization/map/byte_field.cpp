#include "localization/map/byte_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace castaway::localization {
namespace {

int divided_up(int value, int by) { return (value + by - 1) / by; }

}  // namespace

ByteField::ByteField(const OccupancyGrid& grid, const DistanceField& distances,
                     const ByteFieldConfig& config) {
  const GridFrame& fine = grid.frame;
  const int factor =
      std::max(1, static_cast<int>(std::lround(config.resolution / fine.resolution)));
  frame_ = {divided_up(fine.width, factor), divided_up(fine.height, factor),
            fine.resolution * factor, fine.T_map_grid};
  padding_ = static_cast<int>(std::ceil(config.padding / frame_.resolution)) + 1;
  stride_ = frame_.width + 2 * padding_;
  bytes_.assign(static_cast<std::size_t>(stride_ * (frame_.height + 2 * padding_)), 0);
  free_.assign(frame_.size(), false);
  for (int row = 0; row < fine.height; ++row) {
    for (int column = 0; column < fine.width; ++column) {
      const std::size_t i = fine.index({column, row});
      const double z = static_cast<double>(distances.values()[i]) / config.sigma;
      const auto byte = static_cast<std::uint8_t>(std::lround(255.0 * std::exp(-0.5 * z * z)));
      std::uint8_t& coarse = bytes_[static_cast<std::size_t>((row / factor + padding_) * stride_ +
                                                             column / factor + padding_)];
      coarse = std::max(coarse, byte);
      if (grid.cells[i] == CellState::kFree)
        free_[frame_.index({column / factor, row / factor})] = true;
    }
  }
}

ByteField::ByteField(const GridFrame& frame, int padding, const std::vector<std::uint8_t>& bytes,
                     std::vector<bool> free)
    : frame_(frame),
      padding_(padding),
      stride_(frame.width + 2 * padding),
      bytes_(static_cast<std::size_t>(stride_ * (frame.height + 2 * padding)), 0),
      free_(std::move(free)) {
  for (int row = 0; row < frame.height; ++row) {
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(row) * frame.width;
    std::copy(from, from + frame.width, bytes_.begin() + (row + padding) * stride_ + padding);
  }
}

}  // namespace castaway::localization
