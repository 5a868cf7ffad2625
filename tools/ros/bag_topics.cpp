#include "tools/ros/bag_topics.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/ros/ros_sensor.hpp"

namespace castaway::testbed {
namespace {

using Names = std::vector<std::string>;

void add_file(BagInventory& bag, const std::filesystem::path& file,
              std::map<std::string, BagTopicInfo>& topics) {
  BagFile reader(file);
  while (const auto message = reader.next()) {
    const McapChannel& channel = *message->channel;
    BagTopicInfo& topic = topics[channel.topic];
    if (topic.messages++ == 0) {
      const McapSchema* schema = reader.schema_of(channel);
      topic = {channel.topic, schema != nullptr ? schema->name : "", channel.encoding,
               channel.metadata, 1};
    }
    const std::int64_t time = message->log_time_ns;
    bag.start_ns = bag.messages == 0 ? time : std::min(bag.start_ns, time);
    bag.end_ns = bag.messages == 0 ? time : std::max(bag.end_ns, time);
    ++bag.messages;
  }
  for (const auto& [name, texts] : reader.metadata()) bag.metadata[name] = texts;
  const std::vector<McapAttachmentInfo> attachments = reader.attachments();
  bag.attachments.insert(bag.attachments.end(), attachments.begin(), attachments.end());
  if (const auto warning = reader.warning()) bag.warnings.push_back(*warning);
}

bool is_truth(const std::string& topic) { return topic.starts_with("/ground_truth/"); }

Names topics_of_type(const BagInventory& bag, const std::string& type) {
  Names names;
  for (const BagTopicInfo& topic : bag.topics) {
    if (topic.type == type) names.push_back(topic.name);
  }
  return names;
}

std::string list_of(const BagInventory& bag) {
  Names lines;
  for (const BagTopicInfo& topic : bag.topics) {
    lines.push_back(fmt::format("{} ({})", topic.name, topic.type));
  }
  return lines.empty() ? "none" : fmt::format("{}", fmt::join(lines, ", "));
}

const BagTopicInfo& topic_named(const BagInventory& bag, const std::string& name,
                                const char* option) {
  const auto found = std::find_if(bag.topics.begin(), bag.topics.end(),
                                  [&](const BagTopicInfo& topic) { return topic.name == name; });
  if (found == bag.topics.end()) {
    throw std::runtime_error(fmt::format("{}: {} {}: there is no such topic; available are: {}",
                                         bag.name, option, name, list_of(bag)));
  }
  return *found;
}

/// The topic named by an option; its type must be one of `types`.
std::string require_topic(const BagInventory& bag, const std::string& name, const char* option,
                          const Names& types) {
  const BagTopicInfo& topic = topic_named(bag, name, option);
  if (std::find(types.begin(), types.end(), topic.type) == types.end()) {
    throw std::runtime_error(fmt::format("{}: {} {}: its type is {}; expected {}", bag.name, option,
                                         name, topic.type, fmt::join(types, " or ")));
  }
  return name;
}

/// The only candidate, or the one with the usual name. Empty if there are none; throws if several
/// remain.
std::string only_one(const BagInventory& bag, const Names& names, const std::string& usual,
                     const char* option) {
  if (names.empty()) return "";
  if (names.size() == 1) return names.front();
  if (std::find(names.begin(), names.end(), usual) != names.end()) return usual;
  throw std::runtime_error(fmt::format("{}: {} topics are possible; choose one with {}: {}",
                                       bag.name, names.size(), option, fmt::join(names, ", ")));
}

/// True for scans and clouds of castaway's own bags, of which all lidars are used.
bool has_lidar_name(const BagInventory& bag, const std::string& name) {
  return topic_named(bag, name, "").metadata.contains("castaway.lidar");
}

Names choose_clouds(const BagInventory& bag, const BagTopicOptions& options) {
  for (const std::string& name : options.clouds) {
    require_topic(bag, name, "--points-topic", {ros::PointCloud2::kType});
  }
  if (!options.clouds.empty() || !options.in_space) return options.clouds;
  const Names names = topics_of_type(bag, ros::PointCloud2::kType);
  Names own;
  std::ranges::copy_if(names, std::back_inserter(own),
                       [&](const std::string& name) { return has_lidar_name(bag, name); });
  const bool scans = !options.scans.empty() || !topics_of_type(bag, ros::LaserScan::kType).empty();
  if (!own.empty() || names.empty() || scans) return own;
  return {only_one(bag, names, "/points", "--points-topic")};
}

/// True for clouds that are scans of their own, not layers of other scans.
bool replace_scans(const BagInventory& bag, const Names& clouds) {
  return std::ranges::any_of(clouds,
                             [&](const std::string& name) { return !has_lidar_name(bag, name); });
}

Names choose_scans(const BagInventory& bag, const BagTopicOptions& options) {
  if (!options.scans.empty()) {
    for (const std::string& name : options.scans) {
      require_topic(bag, name, "--scan-topic", {ros::LaserScan::kType});
    }
    return options.scans;
  }
  Names names = topics_of_type(bag, ros::LaserScan::kType);
  if (names.empty()) {
    throw std::runtime_error(fmt::format("{}: holds no {}; its topics are: {}", bag.name,
                                         ros::LaserScan::kType, list_of(bag)));
  }
  const bool ours = std::all_of(names.begin(), names.end(),
                                [&](const std::string& name) { return has_lidar_name(bag, name); });
  if (ours) return names;
  return {only_one(bag, names, "/scan", "--scan-topic")};
}

std::string choose_odometry(const BagInventory& bag, const BagTopicOptions& options) {
  if (!options.odometry.empty()) {
    const std::string name = require_topic(bag, options.odometry, "--odom-topic",
                                           {ros::Odometry::kType, ros::TFMessage::kType});
    return topic_named(bag, name, "").type == ros::Odometry::kType ? name : "";
  }
  Names names = topics_of_type(bag, ros::Odometry::kType);
  names.erase(std::remove_if(names.begin(), names.end(), is_truth), names.end());
  std::string name = only_one(bag, names, "/odom", "--odom-topic");
  if (name.empty() && topics_of_type(bag, ros::TFMessage::kType).empty()) {
    throw std::runtime_error(fmt::format("{}: holds neither {} nor {}; its topics are: {}",
                                         bag.name, ros::Odometry::kType, ros::TFMessage::kType,
                                         list_of(bag)));
  }
  return name;
}

/// Of several by type, /imu or the /imu/data of REP-145 is the usual one.
std::string choose_imu(const BagInventory& bag, const BagTopicOptions& options) {
  if (options.imu == "none") return "";
  if (!options.imu.empty()) {
    return require_topic(bag, options.imu, "--imu-topic", {ros::Imu::kType});
  }
  if (!options.in_space) return "";
  const Names names = topics_of_type(bag, ros::Imu::kType);
  const bool plain = std::find(names.begin(), names.end(), "/imu") != names.end();
  return only_one(bag, names, plain ? "/imu" : "/imu/data", "--imu-topic");
}

/// `mcap convert` keeps the messages of a ROS 1 bag as they are.
void refuse_ros1(const BagInventory& bag) {
  const bool any = std::ranges::any_of(
      bag.topics, [](const BagTopicInfo& topic) { return topic.encoding == "ros1"; });
  if (!any) return;
  throw std::runtime_error(
      fmt::format("{}: its messages are those of ROS 1; convert the bag to ROS 2 first, e.g. by "
                  "rosbags-convert "
                  "of the Python package rosbags",
                  bag.name));
}

std::string there_or_empty(const BagInventory& bag, const std::string& name, const char* type) {
  const Names names = topics_of_type(bag, type);
  return std::find(names.begin(), names.end(), name) != names.end() ? name : "";
}

void require_cdr(const BagInventory& bag, const Names& names) {
  for (const std::string& name : names) {
    if (name.empty()) continue;
    const std::string& encoding = topic_named(bag, name, "").encoding;
    if (encoding == "cdr") continue;
    throw std::runtime_error(
        fmt::format("{}: {} is encoded as '{}'; bags of ROS 2 (cdr) are read, convert it first",
                    bag.name, name, encoding));
  }
}

}  // namespace

BagInventory take_inventory(const std::string& name, std::vector<std::filesystem::path> files) {
  BagInventory bag;
  bag.name = name;
  bag.files = std::move(files);
  std::map<std::string, BagTopicInfo> topics;
  for (const auto& file : bag.files) add_file(bag, file, topics);
  for (const auto& [topic, info] : topics) bag.topics.push_back(info);
  return bag;
}

BagTopicChoice choose_topics(const BagInventory& bag, const BagTopicOptions& options) {
  refuse_ros1(bag);
  BagTopicChoice choice;
  choice.clock_offset = options.clock_offset;
  choice.clouds = choose_clouds(bag, options);
  const bool clouds_alone = options.scans.empty() && replace_scans(bag, choice.clouds);
  if (!clouds_alone) choice.scans = choose_scans(bag, options);
  choice.odometry = choose_odometry(bag, options);
  if (!options.truth.empty()) {
    choice.truth = require_topic(
        bag, options.truth, "--truth-topic",
        {ros::Odometry::kType, ros::PoseStamped::kType, ros::PoseWithCovarianceStamped::kType});
  } else {
    choice.truth = there_or_empty(bag, "/ground_truth/odom", ros::Odometry::kType);
    choice.scan_truth = there_or_empty(bag, "/ground_truth/scan_pose", ros::PoseStamped::kType);
  }
  choice.map = only_one(bag, topics_of_type(bag, ros::OccupancyGrid::kType), "/map", "--map");
  choice.imu = choose_imu(bag, options);
  Names taken = choice.scans;
  taken.insert(taken.end(), choice.clouds.begin(), choice.clouds.end());
  taken.insert(taken.end(),
               {choice.odometry, choice.truth, choice.scan_truth, choice.map, choice.imu});
  require_cdr(bag, taken);
  return choice;
}

}  // namespace castaway::testbed
