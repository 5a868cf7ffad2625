#include "tools/ros/clouds/cloud_field.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

using Kind = ScalarKind;

/// Types by their numbers, from 1.
constexpr std::array<ScalarType, 8> kTypes{{{Kind::kSigned, 1},
                                            {Kind::kUnsigned, 1},
                                            {Kind::kSigned, 2},
                                            {Kind::kUnsigned, 2},
                                            {Kind::kSigned, 4},
                                            {Kind::kUnsigned, 4},
                                            {Kind::kFloat, 4},
                                            {Kind::kFloat, 8}}};
constexpr std::uint64_t kMostPoints = 10'000'000;

bool is_known_type(const ros::PointField& field) {
  return field.datatype >= 1 && field.datatype <= kTypes.size();
}

void validate(const ros::PointField& field, const ros::PointCloud2& cloud) {
  if (!is_known_type(field)) {
    throw std::runtime_error(fmt::format("a PointCloud2 has field '{}' of the unknown type {}",
                                         field.name, field.datatype));
  }
  const std::uint64_t end = std::uint64_t{field.offset} + kTypes.at(field.datatype - 1U).size;
  if (end <= cloud.point_step) return;
  throw std::runtime_error(fmt::format("a PointCloud2 has field '{}' beyond its points of {} bytes",
                                       field.name, cloud.point_step));
}

}  // namespace

CloudField::CloudField(const ros::PointCloud2& cloud, const ros::PointField& field)
    : cloud_(&cloud), offset_(field.offset), type_(kTypes.at(field.datatype - 1U)) {}

double CloudField::at(std::size_t point) const {
  const std::size_t row = point / cloud_->width;
  const std::size_t begin =
      row * cloud_->row_step + (point % cloud_->width) * cloud_->point_step + offset_;
  const std::string_view bytes(reinterpret_cast<const char*>(cloud_->data.data()) + begin,
                               type_.size);
  return scalar_at(bytes, type_, cloud_->is_bigendian ? std::endian::big : std::endian::little);
}

void validate(const ros::PointCloud2& cloud) {
  const std::uint64_t points = std::uint64_t{cloud.width} * cloud.height;
  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  if (points > kMostPoints || row > cloud.row_step ||
      std::uint64_t{cloud.height} * cloud.row_step > cloud.data.size()) {
    throw std::runtime_error(fmt::format(
        "a PointCloud2 says {} x {} points of {} bytes in rows of {} and holds {} bytes",
        cloud.width, cloud.height, cloud.point_step, cloud.row_step, cloud.data.size()));
  }
  for (const ros::PointField& field : cloud.fields) validate(field, cloud);
}

std::optional<CloudField> field_of(const ros::PointCloud2& cloud,
                                   const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto found = std::ranges::find(cloud.fields, name, &ros::PointField::name);
    if (found != cloud.fields.end()) return CloudField(cloud, *found);
  }
  return std::nullopt;
}

CloudField require_field(const ros::PointCloud2& cloud, const std::string& name) {
  if (const auto field = field_of(cloud, {name})) return *field;
  std::string names;
  for (const ros::PointField& field : cloud.fields) {
    names += (names.empty() ? "" : ", ") + field.name;
  }
  throw std::runtime_error(
      fmt::format("a PointCloud2 has no field '{}'; its fields are: {}", name, names));
}

}  // namespace castaway::testbed
