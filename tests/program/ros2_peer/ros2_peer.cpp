// A node that stands for those of users: Fast DDS, Fast CDR and messages written from ROS 2's own
// descriptions, with mh_amcl behind them. It plays until the simulator has gone or nothing has come
// for long, then prints what it received as JSON.
#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "localization/geometry/random.hpp"
#include "tests/program/ros2_peer/sensor_watch.hpp"
#include "tests/program/ros2_peer/served_localizer.hpp"

namespace {

using Clock = std::chrono::steady_clock;
using castaway::peer::Manners;
using castaway::peer::SensorWatch;
using castaway::peer::ServedLocalizer;
using castaway::peer::Wire;

/// Counts the messages of topics whatever they hold.
class Watch {
 public:
  /// `topics`: "name type".
  Watch(Wire& wire, const std::vector<std::string>& topics) {
    for (const std::string& topic : topics) {
      const std::size_t blank = topic.find(' ');
      const std::string name = topic.substr(0, blank);
      readers_[name] = wire.reader(name, topic.substr(blank + 1), {true, false, 1000});
      counts_[name] = 0;
    }
  }
  bool turn() {
    bool any = false;
    for (const auto& [name, reader] : readers_) {
      while (castaway::peer::take_bytes(*reader)) {
        ++counts_[name];
        any = true;
      }
    }
    return any;
  }
  [[nodiscard]] const std::map<std::string, int>& counts() const { return counts_; }

 private:
  std::map<std::string, castaway::peer::dds::DataReader*> readers_;
  std::map<std::string, int> counts_;
};

/// Sends what is no transform and no pose on their topics until the simulator has gone.
void send_wrong_types(Wire& wire) {
  using castaway::peer::String;
  auto* tf = wire.writer("rt/tf", String::kType, {true, false, 10});
  auto* pose = wire.writer("rt/amcl_pose", String::kType, {true, true, 1});
  auto* clock = wire.reader("rt/clock", castaway::peer::Clock::kType, {false, false, 1});
  const auto is_here = [&] {
    castaway::peer::dds::SubscriptionMatchedStatus status;
    clock->get_subscription_matched_status(status);
    return status.current_count > 0;
  };
  const auto end = Clock::now() + std::chrono::seconds(60);
  bool was_here = false;
  while (Clock::now() < end && (is_here() || !was_here)) {
    was_here = was_here || is_here();
    castaway::peer::write(*tf, String{"here I am"});
    castaway::peer::write(*pose, String{"here I am"});
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

void print(const castaway::peer::Received& received, const Watch& watch, const SensorWatch& sensors,
           const Wire& wire) {
  nlohmann::json root;
  root["messages"] = received.messages;
  for (const auto& [topic, stamps] : received.stamps) root["stamps"][topic] = stamps.size();
  root["publications"] = wire.publications().seen();
  root["watched"] = watch.counts();
  root["imu"] = sensors.imu();
  root["points"] = sensors.points();
  root["frames"] = received.frames;
  root["description"] = received.description;
  std::printf("%s\n", root.dump().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("A node of ROS 2 for tests");
  int domain = 0;
  std::uint64_t seed = 1;
  double patience_s = 60.0;
  double first_patience_s = 60.0;
  int scans = 0;
  std::string range = "localhost";
  bool wrong_types = false;
  std::vector<std::string> watched;
  std::string imu;
  std::string points;
  Manners manners;
  app.add_option("--domain", domain);
  app.add_option("--seed", seed, "Of the run: the localizer's are those of 'mh_amcl' in it");
  app.add_option("--patience", patience_s, "[s] Ends when nothing has come for so long");
  app.add_option("--first-patience", first_patience_s);
  app.add_option("--scans", scans, "Breaks off after so many scans");
  app.add_option("--scan-topic", manners.scan_topic);
  app.add_option("--answer-every", manners.answer_every);
  app.add_option("--late", manners.late_ms, "[ms]");
  app.add_option("--ahead", manners.ahead_ns, "[ns]");
  app.add_option("--range", range, "localhost, whitelist or subnet: see Wire");
  app.add_flag("--wrong-types", wrong_types);
  app.add_option("--watch", watched, "Topics to count, as on the wire: 'NAME TYPE'");
  app.add_option("--imu", imu, "Topic of an Imu, as on the wire");
  app.add_option("--points", points, "Topic of a PointCloud2, as on the wire");
  app.add_option("--drive", manners.drive, "plain or stamped");
  app.add_flag("--twice", manners.twice);
  app.add_flag("--stay", manners.stays, "Goes on with the next simulator");
  app.add_flag("--garbage", manners.garbage);
  app.add_flag("!--no-transform", manners.with_transform);
  app.add_flag("!--unknown-start", manners.known_start);
  CLI11_PARSE(app, argc, argv);

  Wire wire(domain, range);
  if (wrong_types) {
    send_wrong_types(wire);
    return 0;
  }
  ServedLocalizer node(wire, castaway::localization::substream(seed, "localizer/mh_amcl")(),
                       manners);
  Watch watch(wire, watched);
  SensorWatch sensors(wire, imu, points);
  auto last = Clock::now();
  const auto is_patient = [&] {
    const double patience = node.received().messages.empty() ? first_patience_s : patience_s;
    return Clock::now() - last < std::chrono::duration<double>(patience);
  };
  while (is_patient() && !node.is_over()) {
    const bool counted = watch.turn();
    const bool sensed = sensors.turn();
    if (node.turn() || counted || sensed) {
      last = Clock::now();
    } else {
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    const auto seen = node.received().stamps.find("scan");
    const bool any = seen != node.received().stamps.end();
    if (scans > 0 && any && static_cast<int>(seen->second.size()) >= scans) break;
  }
  print(node.received(), watch, sensors, wire);
  return 0;
}
