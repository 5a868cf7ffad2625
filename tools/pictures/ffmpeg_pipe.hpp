/// Pictures on their way into a film, through the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "sim/scene/image.hpp"
#include "tools/pictures/picture_config.hpp"

namespace castaway::testbed {

/// Throws std::invalid_argument naming the file or key that does not do.
void validate(const FilmFormat& format);

/// A film that appears under its name when it is complete, and never otherwise.
class FfmpegPipe {
 public:
  /// Starts ffmpeg. Throws std::invalid_argument for a format that does not do,
  /// std::runtime_error where ffmpeg is not installed or the folder cannot be made.
  explicit FfmpegPipe(FilmFormat format);
  /// Ends ffmpeg and removes what it wrote unless `commit` was called.
  ~FfmpegPipe();
  FfmpegPipe(const FfmpegPipe&) = delete;
  FfmpegPipe& operator=(const FfmpegPipe&) = delete;

  /// The next picture, of the format's size. Throws std::runtime_error with ffmpeg's own words if
  /// it gave up.
  void add(const sim::Image& image);
  /// Waits for ffmpeg and puts the film in its place. Throws as `add` does.
  void commit();

 private:
  void start();
  int wait();
  [[noreturn]] void fail();

  FilmFormat format_;
  std::filesystem::path partial_;
  std::FILE* words_ = nullptr;  ///< What ffmpeg says; has no name on disk.
  int socket_ = -1;             ///< To ffmpeg's standard input.
  pid_t ffmpeg_ = -1;
};

}  // namespace castaway::testbed
