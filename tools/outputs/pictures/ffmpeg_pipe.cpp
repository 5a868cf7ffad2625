#include "tools/outputs/pictures/ffmpeg_pipe.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tools/base/output/own_file.hpp"
#include "tools/base/process/fork_child.hpp"

extern char** environ;  // No POSIX header declares it.

namespace castaway::testbed {
namespace {

bool is_webm(const FilmFormat& format) { return format.file.extension() == ".webm"; }

std::vector<std::string> command(const FilmFormat& format, const std::string& out) {
  std::vector<std::string> words{"ffmpeg",
                                 "-nostdin",
                                 "-y",
                                 "-loglevel",
                                 "error",
                                 "-f",
                                 "rawvideo",
                                 "-pix_fmt",
                                 "rgb24",
                                 "-s",
                                 fmt::format("{}x{}", format.width, format.height),
                                 "-r",
                                 std::to_string(format.fps),
                                 "-i",
                                 "pipe:0"};
  const std::vector<std::string> coding =
      is_webm(format)
          ? std::vector<std::string>{"-c:v",      "libvpx-vp9", "-crf",      "32", "-b:v", "0",
                                     "-deadline", "realtime",   "-cpu-used", "6",  "-f",   "webm"}
          : std::vector<std::string>{"-c:v", "libx264",   "-preset",    "veryfast", "-crf",
                                     "21",   "-movflags", "+faststart", "-f",       "mp4"};
  words.insert(words.end(), {"-pix_fmt", "yuv420p"});
  words.insert(words.end(), coding.begin(), coding.end());
  words.push_back(out);
  return words;
}

}  // namespace

void validate(const FilmFormat& format) {
  const std::string extension = format.file.extension().string();
  if (extension != ".mp4" && extension != ".webm") {
    throw std::invalid_argument(format.file.string() + ": a film's name must end in .mp4 or .webm");
  }
  for (const int side : {format.width, format.height}) {
    if (side < 16 || side > 4096 || side % 2 != 0) {
      throw std::invalid_argument(
          fmt::format("a film of {} px; each side must be an even number of 16 to 4096", side));
    }
  }
  if (format.fps < 1 || format.fps > 120) {
    throw std::invalid_argument(
        fmt::format("a film of {} pictures a second; it must be 1 to 120", format.fps));
  }
}

FfmpegPipe::FfmpegPipe(FilmFormat format) : format_(std::move(format)), partial_(format_.file) {
  validate(format_);
  require_own_file(format_.file);
  partial_.replace_filename(".castaway-unfinished-" + format_.file.filename().string());
  const std::filesystem::path folder = format_.file.parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder);
  std::error_code none;
  std::filesystem::remove(partial_, none);  // ffmpeg would write through a link.
  words_ = std::tmpfile();
  if (words_ == nullptr)
    throw std::runtime_error("cannot create a temporary file for ffmpeg's messages");
  try {
    start();
  } catch (...) {
    std::fclose(words_);
    throw;
  }
}

/// Uses a socket rather than a pipe: writing to a program that has ended is then an error, not a
/// signal.
void FfmpegPipe::start() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::runtime_error("cannot create a socket to ffmpeg");
  }
  try {
    ffmpeg_ = spawn_program(command(format_, partial_.string()), ends[1], -1, fileno(words_));
    socket_ = ends[0];
    ::close(ends[1]);
  } catch (const std::runtime_error&) {
    for (const int end : ends) ::close(end);
    throw std::runtime_error(format_.file.string() +
                             ": a film needs ffmpeg, which cannot be started; install it "
                             "(apt-get install ffmpeg) or leave --video away");
  }
}

FfmpegPipe::~FfmpegPipe() {
  if (ffmpeg_ > 0) wait();
  std::fclose(words_);
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

/// Closes the input and returns ffmpeg's exit status.
int FfmpegPipe::wait() {
  ::close(socket_);
  return wait_for(std::exchange(ffmpeg_, -1));
}

void FfmpegPipe::fail() {
  if (ffmpeg_ > 0) wait();
  std::string text(400, '\0');
  std::rewind(words_);
  text.resize(std::fread(text.data(), 1, text.size(), words_));
  for (char& c : text) c = c == '\n' ? ' ' : c;
  throw std::runtime_error(format_.file.string() + ": ffmpeg could not write the film: " + text);
}

void FfmpegPipe::add(const sim::Image& image) {
  if (image.width != format_.width || image.height != format_.height) {
    throw std::invalid_argument("a picture of another size than the film's");
  }
  const std::uint8_t* next = image.pixels.data();
  for (std::size_t left = image.pixels.size(); left > 0;) {
    const ssize_t sent = ::send(socket_, next, left, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) fail();
    next += sent;
    left -= static_cast<std::size_t>(sent);
  }
}

void FfmpegPipe::commit() {
  if (wait() != 0) fail();
  put_own_file(format_.file, [&](const auto& draft) { std::filesystem::rename(partial_, draft); });
}

}  // namespace castaway::testbed
