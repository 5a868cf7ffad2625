#include "tools/ros/bag_markers.hpp"

#include <algorithm>
#include <array>

#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

constexpr std::int32_t kArrow = 0;
constexpr std::int32_t kCylinder = 3;
constexpr std::int32_t kDeleteAll = 3;  // A marker action.
constexpr double kPersonDiameter = 0.5;
constexpr double kPersonHeight = 1.7;

/// Colours that colour-blind readers can distinguish (Okabe and Ito, 2008).
constexpr std::array<std::array<float, 3>, 7> kColours{{{0.00F, 0.45F, 0.70F},
                                                        {0.84F, 0.37F, 0.00F},
                                                        {0.00F, 0.62F, 0.45F},
                                                        {0.80F, 0.47F, 0.65F},
                                                        {0.90F, 0.62F, 0.00F},
                                                        {0.34F, 0.71F, 0.91F},
                                                        {0.94F, 0.89F, 0.26F}}};

ros::Marker marker(Stamp stamp, const char* name_space, int id, const SE2& pose) {
  ros::Marker marker;
  marker.header = ros_header(stamp, "map");
  marker.ns = name_space;
  marker.id = id;
  marker.pose = to_ros_pose(pose);
  return marker;
}

}  // namespace

ros::MarkerArray people_markers(Stamp stamp, const std::vector<PersonTruth>& people) {
  ros::MarkerArray message;
  for (const PersonTruth& person : people) {
    ros::Marker& body =
        message.markers.emplace_back(marker(stamp, "people", person.id, person.T_map_person));
    body.type = kCylinder;
    body.pose.position.z = 0.5 * kPersonHeight;
    body.scale = {kPersonDiameter, kPersonDiameter, kPersonHeight};
    body.color = {0.84F, 0.37F, 0.0F, 0.9F};
  }
  return message;
}

ros::MarkerArray hypothesis_markers(Stamp stamp,
                                    const std::vector<localization::PopulationView>& populations,
                                    bool heights) {
  ros::MarkerArray message;
  message.markers.push_back(marker(stamp, "hypotheses", 0, {}));
  message.markers.back().action = kDeleteAll;
  for (const auto& population : populations) {
    ros::Marker& arrow = message.markers.emplace_back(
        marker(stamp, "hypotheses", population.id, population.T_map_base));
    if (heights && population.footing) arrow.pose.position.z = population.footing->z;
    const double length = population.selected ? 1.0 : 0.6;
    const auto& colour = kColours[static_cast<std::size_t>(population.id) % kColours.size()];
    const float opacity = 0.3F + 0.7F * static_cast<float>(population.share);
    arrow.type = kArrow;
    arrow.scale = {length, 0.2 * length, 0.2 * length};
    arrow.color = {colour[0], colour[1], colour[2], std::clamp(opacity, 0.3F, 1.0F)};
  }
  return message;
}

}  // namespace castaway::testbed
