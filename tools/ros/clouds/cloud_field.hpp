/// Numbers of the points of a PointCloud2.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/base/formats/points/scalar.hpp"
#include "tools/ros/ros_sensor.hpp"

namespace castaway::testbed {

/// One number of each point. The cloud must outlive it.
class CloudField {
 public:
  CloudField(const ros::PointCloud2& cloud, const ros::PointField& field);

  /// Of a point, counted row by row.
  [[nodiscard]] double at(std::size_t point) const;
  [[nodiscard]] const ScalarType& type() const { return type_; }

 private:
  const ros::PointCloud2* cloud_;
  std::size_t offset_;
  ScalarType type_;
};

/// Throws std::runtime_error unless the data hold all points with all fields, each of a known type.
void validate(const ros::PointCloud2& cloud);

/// The first of these fields that a valid cloud has.
std::optional<CloudField> field_of(const ros::PointCloud2& cloud,
                                   const std::vector<std::string>& names);

/// The field, or std::runtime_error naming those that the cloud has.
CloudField require_field(const ros::PointCloud2& cloud, const std::string& name);

}  // namespace castaway::testbed
