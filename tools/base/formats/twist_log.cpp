#include "tools/base/formats/twist_log.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kHeader = "t_s,v,w";
constexpr double kLargestTwist = 1e7;  // [s], [m/s], [rad/s]

/// Parses three comma-separated numbers of at most `kLargestTwist`; false on anything else.
bool parse(std::string_view line, std::array<double, 3>& numbers) {
  const char* at = line.data();
  const char* const end = at + line.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return false;
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc{} || !(std::abs(numbers[i]) <= kLargestTwist)) return false;
    at = next;
  }
  return at == end;
}

std::string_view trim_end(std::string_view line) {
  const auto last = line.find_last_not_of(" \t\r");
  return last == std::string_view::npos ? std::string_view() : line.substr(0, last + 1);
}

}  // namespace

std::vector<TwistLine> read_twist_log(const std::filesystem::path& path) {
  std::istringstream stream(read_file(path));
  std::vector<TwistLine> log;
  int number = 0;
  for (std::string text; std::getline(stream, text);) {
    ++number;
    const std::string_view line = trim_end(text);
    if (line.empty() || line.front() == '#' || line == kHeader) continue;
    const auto fail = [&](const char* what) {
      throw std::runtime_error(fmt::format("{}:{}: {}", path.string(), number, what));
    };
    std::array<double, 3> values{};
    if (!parse(line, values)) fail("no command; write time [s], speed [m/s], turn rate [rad/s]");
    if (!log.empty() && values[0] < log.back().t_s) fail("goes back in time; sort the lines");
    log.push_back({values[0], values[1], values[2]});
  }
  if (log.empty()) throw std::runtime_error(path.string() + ": holds no commands 't_s,v,w'");
  return log;
}

}  // namespace castaway::testbed
