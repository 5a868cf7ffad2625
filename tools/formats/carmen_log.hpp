/// Reading CARMEN logs, plain or gzipped, line by line.
///
/// Only what a localizer needs is kept; messages of other names are skipped. A line of a known name
/// that cannot be read is an error with file and line.
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
  double time_s = 0.0;  ///< The logger's clock: the last number of the line.
  localization::SE2 T_odom_base;
};

/// `FLASER` or `ROBOTLASER1`
struct CarmenLaser {
  double time_s = 0.0;
  localization::SE2 T_odom_laser;
  localization::SE2 T_odom_base;
  std::vector<float> ranges;  ///< [m] Misses are the maximum range.
  /// What only ROBOTLASER1 says of itself.
  struct Device {
    double angle_min = 0.0;        ///< [rad]
    double field_of_view = 0.0;    ///< [rad]
    double angle_increment = 0.0;  ///< [rad]
    double range_max = 0.0;        ///< [m]
  };
  std::optional<Device> device;
};

/// `TRUEPOS true_x true_y true_theta odom_x odom_y odom_theta t host t`: the truth of the scan just
/// before it.
struct CarmenTruth {
  double time_s = 0.0;
  localization::SE2 T_map_base;
};

using CarmenMessage = std::variant<CarmenParam, CarmenOdometry, CarmenLaser, CarmenTruth>;

/// Reads one log from its beginning to its end.
class CarmenLogReader {
 public:
  /// Throws std::runtime_error if the file cannot be opened.
  explicit CarmenLogReader(const std::filesystem::path& path);
  ~CarmenLogReader();

  /// The next message of a known kind; nothing at the end of the log. Throws std::runtime_error
  /// "file:line: ..." on a broken line and on a gzip stream that is cut short.
  std::optional<CarmenMessage> next();
  /// "file:line" of the newest message.
  [[nodiscard]] std::string place() const;

 private:
  bool read_line();

  struct Stream;
  std::unique_ptr<Stream> stream_;
  std::string name_;
  std::string line_;
  std::int64_t line_number_ = 0;
};

/// Reads one line; nothing for an empty line, a comment and a message of an unknown name. Throws
/// std::runtime_error on a broken line, without its place.
std::optional<CarmenMessage> parse_carmen_line(const std::string& line);

}  // namespace castaway::testbed
