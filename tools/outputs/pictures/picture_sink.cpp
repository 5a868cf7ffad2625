#include "tools/outputs/pictures/picture_sink.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"
#include "tools/outputs/pictures/map_picture.hpp"

namespace castaway::testbed {

void validate(const PictureConfig& config) {
  if (!(config.every_s >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("snapshots.every_s is {}; it must be 0 (none) or more", config.every_s));
  }
  for (const int side : {config.width, config.height}) {
    if (side < 16 || side > 8192) {
      throw std::invalid_argument(
          fmt::format("a picture of {} px; each side must be 16 to 8192 px", side));
    }
  }
}

PictureSink::PictureSink(const std::filesystem::path& run_folder, const RunInfo& info,
                         PictureWorld world, const PictureConfig& config)
    : folder_(run_folder / "snapshots"),
      world_(std::move(world)),
      config_(config),
      awaiting_recovery_(!info.known_start) {
  validate(config_);
  if (world_.map) map_item_ = map_item(*world_.map);
  try {
    renderer_.emplace(config_.width, config_.height);
  } catch (const std::runtime_error& error) {
    missing_ = error.what();
    write_file(folder_ / "none.txt", *missing_ + "\n");
  }
}

void PictureSink::on_event(const RunEvent& event) {
  if (!event.is<KidnapEvent>()) return;
  ++kidnaps_;
  kidnap_to_show_ = event.stamp;
  awaiting_recovery_ = true;
  right_since_.reset();
}

void PictureSink::on_scan(const ScanRecord& record) {
  if (!renderer_) return;
  const std::string what = occasion(record);
  if (!what.empty()) take(record, what);
}

std::string PictureSink::occasion(const ScanRecord& record) {
  std::string what;
  if (config_.every_s > 0.0 && record.stamp >= next_by_time_.value_or(record.stamp)) {
    const Stamp period(std::llround(config_.every_s * 1e9));
    next_by_time_ = next_by_time_.value_or(record.stamp) + period;
    what = "time";
  }
  const bool recovered = has_recovered(record);
  if (config_.on_events && recovered) what = fmt::format("recovery-{}", kidnaps_);
  if (kidnap_to_show_ && record.stamp >= *kidnap_to_show_) {
    kidnap_to_show_.reset();
    if (config_.on_events) what = fmt::format("kidnap-{}", kidnaps_);
  }
  return what;
}

bool PictureSink::has_recovered(const ScanRecord& record) {
  if (!awaiting_recovery_ || kidnap_to_show_ || record.localizers.empty()) return false;
  MetricRow row{record.stamp, record.T_odom_base, T_map_base_of(record.true_pose), std::nullopt,
                false};
  const auto& estimate = record.localizers.front().estimate;
  if (estimate) row.T_map_base_estimate = estimate->T_map_base;
  if (!is_right(row, {})) {
    right_since_.reset();
    return false;
  }
  if (!right_since_) right_since_ = record.stamp;
  if (record.stamp - *right_since_ < std::chrono::seconds(1)) return false;
  awaiting_recovery_ = false;
  return true;
}

void PictureSink::take(const ScanRecord& record, const std::string& occasion) {
  const std::string name = fmt::format("t{:08.3f}-{}", seconds(record.stamp), occasion);
  if (!world_.world.empty() && record.true_pose) {
    save(renderer_->render(chase_scene(world_, record)), name + "-chase.png");
    save(renderer_->render(overview_scene(world_, record)), name + "-overview.png");
  }
  if (map_item_) save(map_picture(*renderer_, world_, *map_item_, record), name + "-map.png");
}

void PictureSink::save(const sim::Image& image, const std::string& name) const {
  write_file(folder_ / name, sim::encode_png(image));
}

}  // namespace castaway::testbed
