#include "tools/ros/bag_json.hpp"

#include <map>

#include "tools/ros/cdr.hpp"
#include "tools/ros/ros_visualization.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using ToJson = Json (*)(std::string_view);

template <typename Message>
Json decode_to_json(std::string_view data) {
  return RosJson::of(CdrReader::decode<Message>(data));
}

template <typename... Messages>
std::map<std::string, ToJson> table() {
  return {{Messages::kType, &decode_to_json<Messages>}...};
}

}  // namespace

std::optional<Json> message_json(const std::string& type, std::string_view data) {
  static const std::map<std::string, ToJson> kTypes =
      table<ros::String, ros::Int32MultiArray, ros::PoseStamped, ros::PoseArray,
            ros::PoseWithCovarianceStamped, ros::TwistStamped, ros::TFMessage, ros::LaserScan,
            ros::PointCloud2, ros::JointState, ros::Imu, ros::CompressedImage, ros::OccupancyGrid,
            ros::Odometry, ros::Marker, ros::MarkerArray>();
  const auto found = kTypes.find(type);
  if (found == kTypes.end()) return std::nullopt;
  return found->second(data);
}

}  // namespace castaway::testbed
