#include "tools/base/output/clock_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>

namespace castaway::testbed {
namespace {

/// A text near the beginning of a file of this name.
struct ClockFile {
  const char* name;
  const char* mark;
};

constexpr std::array<ClockFile, 4> kClockFiles{{{"report.html", "<title>castaway: "},
                                                {"timing.csv", "stamp_s,localizer,stage,cpu_ms"},
                                                {"timing.json", "\n  \"wall_s\": "},
                                                {"timing.json", "\n  \"figures\": "}}};

std::string beginning_of(const std::filesystem::path& file) {
  constexpr std::streamsize kBytes = 1024;
  std::string text(static_cast<std::size_t>(kBytes), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), kBytes);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace

bool holds_clock_readings(const std::string& path) {
  return std::any_of(kClockFiles.begin(), kClockFiles.end(),
                     [&](const ClockFile& known) { return path == known.name; });
}

bool is_clock_file(const std::filesystem::path& file) {
  const std::string beginning = beginning_of(file);
  return std::any_of(kClockFiles.begin(), kClockFiles.end(), [&](const ClockFile& known) {
    return file.filename() == known.name && beginning.find(known.mark) != std::string::npos;
  });
}

}  // namespace castaway::testbed
