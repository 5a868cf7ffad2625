/// Pictures of a run: snapshots/*.png.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/render/renderer.hpp"
#include "tools/outputs/pictures/picture_config.hpp"
#include "tools/outputs/pictures/picture_scenes.hpp"
#include "tools/outputs/records/run_history.hpp"

namespace castaway::testbed {

/// Throws std::invalid_argument for a negative time or a size outside 16 to 8192 px.
void validate(const PictureConfig& config);

/// Takes up to three pictures at a time: `t0032.100-kidnap-1-chase.png`, `-overview.png`,
/// `-map.png`. The occasion is `kidnap-K`, `recovery-K` (of the first localizer, once its output
/// has been right for a second; K = 0: from an unknown start) or `time`. Without EGL there are no
/// pictures, but the run continues; `snapshots/none.txt` then states the reason.
class PictureSink final : public RunSink {
 public:
  PictureSink(const std::filesystem::path& run_folder, const RunInfo& info, PictureWorld world,
              const PictureConfig& config);

  void on_event(const RunEvent& event) override;
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp, const RunTiming&) override {}

  /// Why there are no pictures; nothing if there are.
  [[nodiscard]] const std::optional<std::string>& missing() const { return missing_; }

 private:
  [[nodiscard]] std::string occasion(const ScanRecord& record);
  [[nodiscard]] bool has_recovered(const ScanRecord& record);
  void take(const ScanRecord& record, const std::string& occasion);
  void save(const sim::Image& image, const std::string& name) const;

  std::filesystem::path folder_;
  PictureWorld world_;
  PictureConfig config_;
  std::optional<sim::SceneItem> map_item_;
  std::optional<sim::Renderer> renderer_;
  std::optional<std::string> missing_;
  int kidnaps_ = 0;
  std::optional<Stamp> kidnap_to_show_;
  bool awaiting_recovery_;
  std::optional<Stamp> right_since_;
  std::optional<Stamp> next_by_time_;
};

}  // namespace castaway::testbed
