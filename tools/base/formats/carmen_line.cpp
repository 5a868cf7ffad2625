#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "tools/base/formats/carmen_log.hpp"

namespace castaway::testbed {
namespace {

using localization::SE2;

/// Consumes the fields of a line from the front.
class Fields {
 public:
  explicit Fields(std::string_view line) : rest_(line) {}

  std::string_view word(const char* what) {
    const std::size_t begin = rest_.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) {
      throw std::runtime_error(fmt::format("ends before its {}; the line is cut short", what));
    }
    rest_.remove_prefix(begin);
    const std::string_view result = rest_.substr(0, rest_.find_first_of(" \t\r"));
    rest_.remove_prefix(result.size());
    return result;
  }

  double number(const char* what) {
    const std::string_view text = word(what);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool tiny = error == std::errc::result_out_of_range && std::abs(value) < 1.0;
    if ((error != std::errc{} && !tiny) || end != text.data() + text.size() ||
        !std::isfinite(value)) {
      throw std::runtime_error(fmt::format("its {} is '{}', which is no number", what, text));
    }
    return value;
  }

  /// Parses a count; limited by what the rest of the line can hold.
  std::size_t count(const char* what) {
    const std::string_view text = word(what);
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
      throw std::runtime_error(fmt::format("its {} is '{}', which is no count", what, text));
    }
    if (value > rest_.size() / 2) {
      throw std::runtime_error(
          fmt::format("its {} is {}, but the line holds fewer; it is cut short", what, value));
    }
    return value;
  }

  SE2 pose(const char* what) {
    const double x = length(what);
    const double y = length(what);
    return {x, y, localization::wrap_angle(length(what))};
  }

  /// Parses a length or angle and rejects absurd values.
  double length(const char* what) {
    constexpr double kFarthest = 1e7;
    const double value = number(what);
    if (std::abs(value) <= kFarthest) return value;
    throw std::runtime_error(
        fmt::format("its {} holds {}, more than {} (metres, radians)", what, value, kFarthest));
  }

  void skip(int fields, const char* what) {
    for (int i = 0; i < fields; ++i) word(what);
  }

  /// Parses `t host t`: the first time is the sender's clock, the last the logger's.
  double logger_time() {
    constexpr double kLatest = 4e9;  // [s] In nanoseconds it still fits into 64 bits.
    skip(2, "time stamp and host");
    const double time_s = number("logger time");
    if (std::abs(time_s) <= kLatest) return time_s;
    throw std::runtime_error(fmt::format("its logger time is {} s, more than {}", time_s, kLatest));
  }

 private:
  std::string_view rest_;
};

std::vector<float> read_ranges(Fields& fields) {
  std::vector<float> ranges(fields.count("number of ranges"));
  for (float& range : ranges) range = static_cast<float>(fields.number("ranges"));
  return ranges;
}

CarmenLaser read_flaser(Fields& fields) {
  CarmenLaser laser;
  laser.ranges = read_ranges(fields);
  laser.T_odom_laser = fields.pose("laser pose");
  laser.T_odom_base = fields.pose("odometry pose");
  laser.time_s = fields.logger_time();
  return laser;
}

CarmenLaser read_robotlaser(Fields& fields) {
  CarmenLaser laser;
  fields.skip(1, "laser type");
  CarmenLaser::Device device;
  device.angle_min = fields.length("start angle");
  device.field_of_view = fields.length("field of view");
  device.angle_increment = fields.length("angular resolution");
  device.range_max = fields.length("maximum range");
  laser.device = device;
  fields.skip(2, "accuracy and remission mode");
  laser.ranges = read_ranges(fields);
  fields.skip(static_cast<int>(fields.count("number of remissions")), "remissions");
  laser.T_odom_laser = fields.pose("laser pose");
  laser.T_odom_base = fields.pose("robot pose");
  fields.skip(5, "velocities and safety distances");
  laser.time_s = fields.logger_time();
  return laser;
}

CarmenOdometry read_odometry(Fields& fields) {
  CarmenOdometry odometry;
  odometry.T_odom_base = fields.pose("pose");
  fields.skip(3, "velocities and acceleration");
  odometry.time_s = fields.logger_time();
  return odometry;
}

CarmenTruth read_truth(Fields& fields) {
  CarmenTruth truth;
  truth.T_map_base = fields.pose("true pose");
  fields.skip(3, "odometry pose");
  truth.time_s = fields.logger_time();
  return truth;
}

CarmenParam read_param(Fields& fields) {
  CarmenParam param;
  param.name = fields.word("name");
  param.value = fields.word("value");
  return param;
}

std::optional<CarmenMessage> parse(std::string_view name, Fields& fields) {
  if (name == "PARAM") return read_param(fields);
  if (name == "ODOM") return read_odometry(fields);
  if (name == "FLASER") return read_flaser(fields);
  if (name == "ROBOTLASER1") return read_robotlaser(fields);
  if (name == "TRUEPOS") return read_truth(fields);
  return std::nullopt;
}

}  // namespace

std::optional<CarmenMessage> parse_carmen_line(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string::npos || line[begin] == '#') return std::nullopt;
  Fields fields(line);
  const std::string name(fields.word("name"));
  try {
    return parse(name, fields);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

}  // namespace castaway::testbed
