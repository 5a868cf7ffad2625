/// Reads CARMEN logs, plain or gzipped, line by line.
///
/// Only messages that a localizer needs are kept; those of other names are skipped. A malformed
/// line of a known name is an error with file and line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "localization/geometry/se2.hpp"

namespace castaway::testbed {

/// `PARAM name value ...`
struct CarmenParam {
  std::string name;
  std::string value;
};

/// `ODOM x y theta tv rv accel t host t`
struct CarmenOdometry {
  double time_s = 0.0;  ///< Clock of the logger: the last number of the line.
  localization::SE2 T_odom_base;
};

/// `FLASER` or `ROBOTLASER1`
struct CarmenLaser {
  double time_s = 0.0;
  localization::SE2 T_odom_laser;
  localization::SE2 T_odom_base;
  std::vector<float> ranges;  ///< [m] A miss is the maximum range.
  /// Geometry that only ROBOTLASER1 states.
  struct Device {
    double angle_min = 0.0;        ///< [rad]
    double field_of_view = 0.0;    ///< [rad]
    double angle_increment = 0.0;  ///< [rad]
    double range_max = 0.0;        ///< [m]
  };
  std::optional<Device> device;
};

/// `TRUEPOS true_x true_y true_theta odom_x odom_y odom_theta t host t`: the truth of the preceding
/// scan.
struct CarmenTruth {
  double time_s = 0.0;
  localization::SE2 T_map_base;
};

using CarmenMessage = std::variant<CarmenParam, CarmenOdometry, CarmenLaser, CarmenTruth>;

/// Reads one log from beginning to end.
class CarmenLogReader {
 public:
  /// Throws std::runtime_error if the file cannot be opened.
  explicit CarmenLogReader(const std::filesystem::path& path);
  ~CarmenLogReader();

  /// The next message of a known kind; nothing at the end of the log. Throws std::runtime_error
  /// "file:line: ..." on a malformed line or a truncated gzip stream.
  std::optional<CarmenMessage> next();
  /// "file:line" of the newest message.
  [[nodiscard]] std::string place() const;

 private:
  bool read_line();
  /// Refuses, by its first bytes, a file that is no log of CARMEN but one of another kind.
  void refuse_other_formats() const;

  struct Stream;
  std::unique_ptr<Stream> stream_;
  std::string name_;
  std::string line_;
  std::int64_t line_number_ = 0;
};

/// Parses one line; nothing for an empty line, a comment or a message of an unknown name. Throws
/// std::runtime_error, without the place, on a malformed line.
std::optional<CarmenMessage> parse_carmen_line(const std::string& line);

}  // namespace castaway::testbed
