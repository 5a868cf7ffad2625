#include "tools/base/formats/time_list.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::nanoseconds;

/// The time of a line without blanks around it; nothing if it is none.
std::optional<nanoseconds> parse_time(std::string_view line) {
  constexpr double kLatest = 1e9;  // [s]
  double seconds = 0.0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), seconds);
  const bool whole = error == std::errc{} && end == line.data() + line.size();
  if (!whole || !(seconds >= 0.0 && seconds <= kLatest)) return std::nullopt;
  return nanoseconds(std::llround(1e9 * seconds));
}

std::string_view without_blanks(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

std::vector<nanoseconds> read_times(const std::filesystem::path& path) {
  std::istringstream stream(read_file(path));
  std::vector<nanoseconds> times;
  int number = 0;
  for (std::string text; std::getline(stream, text);) {
    ++number;
    const std::string_view line = without_blanks(text);
    if (line.empty() || line.front() == '#') continue;
    const auto fail = [&](const char* what) {
      throw std::runtime_error(fmt::format("{}:{}: {}", path.string(), number, what));
    };
    const auto time = parse_time(line);
    if (!time) fail("no time; write seconds since the start, 0 or more");
    if (!times.empty() && *time < times.back()) fail("goes back in time; sort the lines");
    times.push_back(*time);
  }
  if (times.empty()) throw std::runtime_error(path.string() + ": holds no times");
  return times;
}

std::string times_text(const std::vector<nanoseconds>& times) {
  std::string text;
  for (const nanoseconds time : times) {
    text += fmt::format("{}.{:09}\n", time.count() / 1'000'000'000, time.count() % 1'000'000'000);
  }
  return text;
}

}  // namespace castaway::testbed
