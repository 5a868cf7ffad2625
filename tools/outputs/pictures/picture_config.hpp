/// Configuration of the pictures of a run.
#pragma once

#include <filesystem>

#include <Eigen/Core>

namespace castaway::testbed {

/// Pictures at moments of a run.
struct PictureConfig {
  double every_s = 0.0;   ///< [s] Period of pictures; 0: no periodic pictures.
  bool on_events = true;  ///< At each kidnap and each recovery of the first localizer.
  int width = 960;        ///< [px]
  int height = 720;       ///< [px]
};

/// A video file.
struct FilmFormat {
  std::filesystem::path file;  ///< Ends in .mp4 (H.264) or .webm (VP9).
  int width = 1280;            ///< [px] Even.
  int height = 720;            ///< [px] Even.
  int fps = 20;                ///< [1/s] Frame rate.
};

/// What a film shows.
enum class FilmView {
  kChase,     ///< The robot from behind, and the map in a corner.
  kOverview,  ///< The world from above, and the map in a corner.
  kMap,
};

/// Content and speed of a film.
struct FilmConfig {
  FilmFormat format;
  FilmView view = FilmView::kChase;
  double speed = 1.0;  ///< Seconds of the run per second of film.
};

/// A camera on the robot.
struct CameraConfig {
  double rate_hz = 2.0;                           ///< [Hz] Image rate.
  int width = 640;                                ///< [px]
  int height = 480;                               ///< [px]
  double fov_deg = 70.0;                          ///< [deg] Horizontal field of view.
  Eigen::Vector3d p_base{0.1, 0.0, 0.4};          ///< [m] Position of the optical centre in base.
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();  ///< [rad] Roll, pitch, yaw of the viewing
                                                  ///< direction.
  bool depth = true;                              ///< camera/depth
  bool instances = true;                          ///< camera/instances
};

}  // namespace castaway::testbed
