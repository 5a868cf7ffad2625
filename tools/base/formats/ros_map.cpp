#include "tools/base/formats/ros_map.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

constexpr double kKnownMargin = 1.0;  // [m]
constexpr double kMostOfSide = 0.8;   // Of a side that is known; more is shown as it is.

constexpr double kOccupiedThresh = 0.65;
constexpr double kFreeThresh = 0.196;
constexpr int kUnknownGray = 205;
constexpr double kReportedShare = 1.0;  // [%] Of the pixels; a larger share is reported.

std::int8_t raw_cell(double shade) {
  const int value = static_cast<int>(std::lround(shade * 255.0));
  return static_cast<std::int8_t>(value <= 100 ? value : -1);
}

std::int8_t cell_of(double shade, const RosMapHeader& header) {
  if (header.mode == MapMode::kRaw) return raw_cell(shade);
  const double occupancy = header.negate ? shade : 1.0 - shade;
  if (occupancy >= header.occupied_thresh) return 100;
  if (occupancy <= header.free_thresh) return 0;
  if (header.mode == MapMode::kTrinary) return -1;
  const double range = header.occupied_thresh - header.free_thresh;
  return static_cast<std::int8_t>(std::lround(100.0 * (occupancy - header.free_thresh) / range));
}

std::uint16_t gray_of(std::int8_t cell) {
  if (cell >= 100 * kOccupiedThresh) return 0;
  return cell >= 0 && cell <= 100 * kFreeThresh ? 254 : 205;
}

double percent_of(std::size_t pixels, const GrayImage& image) {
  return 100.0 * static_cast<double>(pixels) /
         static_cast<double>(std::max<std::size_t>(1, image.pixels.size()));
}

/// Formats a number with a decimal point, so that YAML reads it as a float: "0.0", "-11.55".
std::string yaml_number(double value) {
  const std::string text = fmt::format("{}", value == 0.0 ? 0.0 : value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

}  // namespace

Eigen::Vector2d RosMap::to_map(const Eigen::Vector2d& cells_from_corner) const {
  return Eigen::Vector2d(origin_x, origin_y) +
         Eigen::Rotation2Dd(origin_yaw) * (resolution * cells_from_corner);
}

namespace {

/// Makes pixels unknown that are not opaque, as map_server does; raw mode ignores transparency.
void clear_transparent(const GrayImage& image, MapMode mode, RosMap& map) {
  if (image.transparent.empty() || mode == MapMode::kRaw) return;
  const auto width = static_cast<std::size_t>(image.width);
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.transparent.size(); ++i) {
    if (!image.transparent[i]) continue;
    const std::size_t row = static_cast<std::size_t>(image.height) - 1 - i / width;
    map.cells[row * width + i % width] = -1;
    ++count;
  }
  map.warnings.push_back(fmt::format("map {}: {:.1f} % of its picture is transparent: unknown",
                                     map.name, percent_of(count, image)));
}

/// Map savers write unknown cells as grey 205, which is an occupancy of 0.1961.
void warn_of_free_unknown(const GrayImage& image, const RosMapHeader& header, RosMap& map) {
  if (image.max_value != 255 || header.mode == MapMode::kRaw || header.negate) return;
  if (cell_of(kUnknownGray / 255.0, header) != 0) return;
  const auto count = static_cast<std::size_t>(
      std::count(image.pixels.begin(), image.pixels.end(), std::uint16_t{kUnknownGray}));
  if (percent_of(count, image) < kReportedShare) return;
  map.warnings.push_back(fmt::format(
      "map {}: free_thresh {} makes grey {} (unknown, {:.0f} % of the picture) free; "
      "write free_thresh: {}",
      map.name, header.free_thresh, kUnknownGray, percent_of(count, image), kFreeThresh));
}

}  // namespace

RosMap make_ros_map(const GrayImage& image, const RosMapHeader& header, std::string name) {
  std::vector<std::int8_t> cell_of_gray;
  for (int gray = 0; gray <= image.max_value; ++gray) {
    cell_of_gray.push_back(cell_of(static_cast<double>(gray) / image.max_value, header));
  }
  RosMap map{std::move(name), image.width,     image.height,      header.resolution,
             header.origin_x, header.origin_y, header.origin_yaw, {}};
  map.cells.reserve(image.pixels.size());
  const auto width = static_cast<std::ptrdiff_t>(image.width);
  for (auto row = image.pixels.end(); row != image.pixels.begin(); row -= width) {
    std::transform(row - width, row, std::back_inserter(map.cells),
                   [&](std::uint16_t gray) { return cell_of_gray[gray]; });
  }
  clear_transparent(image, header.mode, map);
  warn_of_free_unknown(image, header, map);
  return map;
}

GrayImage map_image(const RosMap& map) {
  GrayImage image{map.width, map.height, 255, {}};
  image.pixels.reserve(map.cells.size());
  const auto width = static_cast<std::ptrdiff_t>(map.width);
  for (auto row = map.cells.end(); row != map.cells.begin(); row -= width) {
    std::transform(row - width, row, std::back_inserter(image.pixels), gray_of);
  }
  return image;
}

RosMap part_of(const RosMap& map, const Eigen::Vector2i& from, const Eigen::Vector2i& size) {
  RosMap part = map;
  part.width = size.x();
  part.height = size.y();
  const Eigen::Vector2d corner = map.to_map(from.cast<double>());
  part.origin_x = corner.x();
  part.origin_y = corner.y();
  part.cells.clear();
  for (int row = from.y(); row < from.y() + size.y(); ++row) {
    const auto first = map.cells.begin() + static_cast<std::ptrdiff_t>(row) * map.width + from.x();
    part.cells.insert(part.cells.end(), first, first + size.x());
  }
  return part;
}

RosMap known_part(const RosMap& map) {
  Eigen::Vector2i low(map.width, map.height);
  Eigen::Vector2i high(0, 0);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.at(column, row) < 0) continue;
      low = low.cwiseMin(Eigen::Vector2i(column, row));
      high = high.cwiseMax(Eigen::Vector2i(column + 1, row + 1));
    }
  }
  const int margin = static_cast<int>(std::ceil(kKnownMargin / map.resolution));
  low = (low.array() - margin).cwiseMax(0);
  high = (high.array() + margin).cwiseMin(Eigen::Array2i(map.width, map.height));
  const Eigen::Vector2i size = high - low;
  const Eigen::Vector2d all(map.width, map.height);
  const bool less = (size.cast<double>().array() < kMostOfSide * all.array()).any();
  return size.minCoeff() > 0 && less ? part_of(map, low, size) : map;
}

std::string ros_map_yaml(const RosMap& map, const std::string& image) {
  return fmt::format(
      "image: {}\nmode: trinary\nresolution: {}\norigin: [{}, {}, {}]\n"
      "negate: 0\noccupied_thresh: {}\nfree_thresh: {}\n",
      image, yaml_number(map.resolution), yaml_number(map.origin_x), yaml_number(map.origin_y),
      yaml_number(map.origin_yaw), kOccupiedThresh, kFreeThresh);
}

void write_ros_map(const RosMap& map, const std::filesystem::path& yaml_path) {
  std::filesystem::path image_path = yaml_path;
  image_path.replace_extension(".pgm");
  write_file(image_path, encode_pgm(map_image(map)));
  write_file(yaml_path, ros_map_yaml(map, image_path.filename().string()));
}

}  // namespace castaway::testbed
