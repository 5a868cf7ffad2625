/// A node of ROS 2 on Fast DDS beside runs of castaway. Each test has a domain of its own.
#pragma once

#include <string>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {

using Json = nlohmann::json;

inline constexpr const char* kRos2Run =
    "run --set outputs.snapshots=false --set outputs.report=false --out run ";

/// A node in the background; it ends when castaway has gone.
class Node {
 public:
  Node(const fs::path& folder, int domain, const std::string& arguments = "")
      : file_(folder / ("node" + std::to_string(domain) + ".json")) {
    const std::string command = "exec '" CASTAWAY_ROS2_PEER "' --domain " + std::to_string(domain) +
                                " " + arguments + " >'" + file_.string() + "' 2>&1";
    thread_ = std::thread([command] { (void)!std::system(command.c_str()); });
  }
  ~Node() {
    if (thread_.joinable()) thread_.join();
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// What it received, once it has ended.
  Json received() {
    thread_.join();
    return Json::parse(text_of(file_));
  }

 private:
  fs::path file_;
  std::thread thread_;
};

/// The localizers of a run with the node of this domain, and settings.
inline std::string node_in(int domain, const std::string& settings = "") {
  return "--localizer mh_amcl --localizer ros2:" + std::to_string(domain) + " " + settings + " ";
}

/// Topics of a run that only lookers-on want.
inline const std::string kWatched =
    "--watch 'rt/castaway/events std_msgs::msg::dds_::String_' "
    "--watch 'rt/castaway/ground_truth/odom nav_msgs::msg::dds_::Odometry_' "
    "--watch 'rt/castaway/mh_amcl/amcl_pose "
    "geometry_msgs::msg::dds_::PoseWithCovarianceStamped_' ";

inline Json ros2_summary(const fs::path& folder) {
  return Json::parse(text_of(folder / "run/summary.json"));
}

/// What became of the scans that were sent to it.
inline Json answers_in(const fs::path& folder) {
  return ros2_summary(folder).at("localizers").at("ros2").at("answers");
}

}  // namespace castaway::test
