/// A video of a run.
#pragma once

#include <optional>
#include <string>

#include "sim/render/renderer.hpp"
#include "tools/outputs/pictures/ffmpeg_pipe.hpp"
#include "tools/outputs/pictures/picture_config.hpp"
#include "tools/outputs/pictures/picture_scenes.hpp"

namespace castaway::testbed {

/// Throws std::invalid_argument for an invalid format, an unknown view or a speed that is not above
/// 0.
void validate(const FilmConfig& config);

/// Copies `inset` with a border into the upper right corner of `image`.
void put_into_corner(const sim::Image& inset, sim::Image& image);

/// Takes an image at the first odometry reading of every period of `speed` / fps seconds. It needs
/// the truth; if it is never known, no film appears.
class FilmSink final : public RunSink {
 public:
  /// Throws std::exception for an invalid configuration or if ffmpeg or EGL is missing.
  FilmSink(const FilmConfig& config, PictureWorld world);

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame& frame) override;
  void on_scan(const ScanRecord& record) override { newest_ = record; }
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  void take(const SE2& T_map_base);

  FilmConfig config_;
  PictureWorld world_;
  std::optional<sim::SceneItem> map_item_;
  sim::Renderer renderer_;
  std::optional<sim::Renderer> inset_;
  FfmpegPipe film_;
  std::optional<ScanRecord> newest_;
  std::optional<Stamp> next_;
  bool any_ = false;
};

}  // namespace castaway::testbed
