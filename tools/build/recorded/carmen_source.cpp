#include "tools/build/recorded/carmen_source.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/build/recorded/carmen_frames.hpp"

namespace castaway::testbed {

double stated_lidar_height(const std::optional<double>& base_height) {
  if (base_height) return *base_height;
  throw std::invalid_argument(
      "a CARMEN log does not say how high its lidar is mounted, and --map3d needs it: state its "
      "height above the ground by --base-height");
}

CarmenSource::CarmenSource(const std::filesystem::path& path, const CarmenSourceConfig& config) {
  CarmenLogReader reader(path);
  CarmenFrames frames(config);
  while (!frames.complete()) {
    const auto message = reader.next();
    if (!message) break;
    frames.add(*message);
  }
  frames_ = frames.take();
  repaired_stamps_ = frames.repaired_stamps();
  const bool has_scan = std::any_of(frames_.begin(), frames_.end(), [](const Frame& frame) {
    return std::holds_alternative<ScanFrame>(frame.data);
  });
  if (!has_scan) {
    throw std::runtime_error(
        fmt::format("{}: no FLASER or ROBOTLASER1 to play from scan {} on; check --from-scan",
                    path.string(), config.from_scan));
  }
}

std::optional<Frame> CarmenSource::next() {
  if (next_ == frames_.size()) return std::nullopt;
  return frames_[next_++];
}

std::optional<SE2> CarmenSource::start_pose() const {
  return T_map_base_of(std::get<OdometryFrame>(frames_.front().data).true_pose);
}

Stamp CarmenSource::duration() const { return frames_.back().stamp - frames_.front().stamp; }

}  // namespace castaway::testbed
