/// Encodes images to a video with the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "sim/scene/image.hpp"
#include "tools/outputs/pictures/picture_config.hpp"

namespace castaway::testbed {

/// Throws std::invalid_argument naming the invalid file or key.
void validate(const FilmFormat& format);

/// A video file that appears only when it is complete.
class FfmpegPipe {
 public:
  /// Starts ffmpeg. Throws std::invalid_argument for an invalid format, std::runtime_error if
  /// ffmpeg is not installed or the folder cannot be created.
  explicit FfmpegPipe(FilmFormat format);
  /// Ends ffmpeg and removes its output unless `commit` was called.
  ~FfmpegPipe();
  FfmpegPipe(const FfmpegPipe&) = delete;
  FfmpegPipe& operator=(const FfmpegPipe&) = delete;

  /// Adds the next image, of the format's size. Throws std::runtime_error with ffmpeg's own message
  /// if it has failed.
  void add(const sim::Image& image);
  /// Waits for ffmpeg and renames the file into place. Throws as `add` does.
  void commit();

 private:
  void start();
  int wait();
  [[noreturn]] void fail();

  FilmFormat format_;
  std::filesystem::path partial_;
  std::FILE* words_ = nullptr;  ///< Error output of ffmpeg, an unnamed file.
  int socket_ = -1;             ///< To ffmpeg's standard input.
  pid_t ffmpeg_ = -1;
};

}  // namespace castaway::testbed
