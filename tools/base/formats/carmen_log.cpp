#include "tools/base/formats/carmen_log.hpp"

#include <array>
#include <stdexcept>

#include <fmt/format.h>
#include <zlib.h>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kLongestLine = 16U << 20U;  // A few bytes of gzip can expand to a line of any
                                                  // length.

}  // namespace

/// Bytes of a file, decompressed if it is gzipped.
struct CarmenLogReader::Stream {
  explicit Stream(const std::filesystem::path& path) {
    require_regular_file(path);
    file = gzopen(path.c_str(), "rb");
  }
  ~Stream() {
    if (file != nullptr) gzclose(file);
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// Refills the buffer; false at the end.
  bool refill() {
    const int count = gzread(file, buffer.data(), static_cast<unsigned>(buffer.size()));
    begin = 0;
    end = count > 0 ? static_cast<std::size_t>(count) : 0;
    return count > 0;
  }
  /// True if the stream is damaged rather than at its end.
  [[nodiscard]] bool broken() const {
    int code = Z_OK;
    gzerror(file, &code);
    return code != Z_OK && code != Z_STREAM_END;
  }

  gzFile file = nullptr;
  std::array<char, 65536> buffer{};
  std::size_t begin = 0;
  std::size_t end = 0;
};

CarmenLogReader::CarmenLogReader(const std::filesystem::path& path)
    : stream_(std::make_unique<Stream>(path)), name_(path.string()) {
  if (stream_->file == nullptr) {
    throw std::runtime_error(name_ + ": cannot be read; check the path and its permissions");
  }
  (void)stream_->refill();
  refuse_other_formats();
}

CarmenLogReader::~CarmenLogReader() = default;

void CarmenLogReader::refuse_other_formats() const {
  const std::string_view head(stream_->buffer.data(), stream_->end);
  if (head.starts_with("version https://git-lfs.github.com/spec/")) {
    throw std::runtime_error(name_ + ": only a Git LFS pointer: git lfs pull fetches the file");
  }
  // MRPT writes objects by the names of their classes, with the length before.
  const std::string_view first = head.substr(0, 64);
  for (const std::string_view name : {"CObservation", "CActionCollection", "CSensoryFrame"}) {
    if (first.find(name) == std::string_view::npos) continue;
    throw std::runtime_error(name_ +
                             ": a rawlog of MRPT, which is not read: convert it to a CARMEN "
                             "log or a bag");
  }
}

std::string CarmenLogReader::place() const { return fmt::format("{}:{}", name_, line_number_); }

bool CarmenLogReader::read_line() {
  line_.clear();
  Stream& stream = *stream_;
  while (stream.begin < stream.end || stream.refill()) {
    const std::string_view rest(stream.buffer.data() + stream.begin, stream.end - stream.begin);
    const std::size_t newline = rest.find('\n');
    line_ += rest.substr(0, newline);
    if (line_.size() > kLongestLine) {
      throw std::runtime_error(fmt::format("{}:{}: a line of more than {} MiB: no CARMEN log",
                                           name_, line_number_ + 1, kLongestLine >> 20U));
    }
    stream.begin += newline == std::string_view::npos ? rest.size() : newline + 1;
    if (newline != std::string_view::npos) return true;
  }
  if (stream.broken()) {
    throw std::runtime_error(
        fmt::format("{}:{}: the gzip stream is cut short or damaged here; copy the file again",
                    name_, line_number_ + 1));
  }
  return !line_.empty();
}

std::optional<CarmenMessage> CarmenLogReader::next() {
  while (read_line()) {
    ++line_number_;
    try {
      if (auto message = parse_carmen_line(line_)) return message;
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(place() + ": " + error.what());
    }
  }
  return std::nullopt;
}

}  // namespace castaway::testbed
