#include "tools/outputs/sinks/tables_hdf5_sink.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint8_t kNobodyKnows = 255;
constexpr const char* kPoseUnit = "m, m, rad";
constexpr const char* kHeightUnit = "m, rad, rad";

using Type = Hdf5Type;

std::vector<double> numbers(const std::optional<SE2>& pose) {
  if (!pose) return {kUnknown, kUnknown, kUnknown};
  return {pose->x, pose->y, pose->yaw};
}

std::vector<double> numbers(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::vector<double> number(const std::optional<double>& value) {
  return {value.value_or(kUnknown)};
}

/// Group path of a lidar; slashes in its name are replaced.
std::string group_of(std::string lidar) {
  if (lidar.empty()) return "/lidars/lidar";
  std::replace(lidar.begin(), lidar.end(), '/', '_');
  return "/lidars/" + lidar;
}

}  // namespace

TablesHdf5Sink::TablesHdf5Sink(const std::filesystem::path& run_folder,
                               std::vector<std::string> localizers,
                               std::shared_ptr<const LabelContext> context)
    : context_(context),
      labeller_(std::move(context)),
      localizers_(std::move(localizers)),
      file_(run_folder / "tables.h5") {
  const auto add = [&](const char* path, int columns, const char* unit, const char* meaning) {
    return file_.add({path, Type::kFloat64, columns, unit, meaning});
  };
  odometry_ = {add("/odometry/stamp_s", 0, "s", "time"),
               add("/odometry/pose", 3, kPoseUnit, "x, y, yaw of base in odom, as measured"),
               add("/odometry/true_pose", 3, kPoseUnit, "x, y, yaw of base in map")};
  people_ = {add("/people/stamp_s", 0, "s", "time of the scan"),
             file_.add({"/people/id", Type::kInt32, 0, "", "number of the person"}),
             add("/people/pose", 3, kPoseUnit, "x, y, yaw in map; x is where it faces"),
             add("/people/velocity", 2, "m/s", "in map"),
             add("/people/gap_m", 0, "m", "from the robot's outline to the body")};
  file_.set_attribute("/", "castaway", CASTAWAY_VERSION);
  file_.set_attribute("/", "conventions",
                      "SI units; REP-103: x forward, y left, z up; map -> odom -> base");
}

void TablesHdf5Sink::on_event(const RunEvent& event) {
  labeller_.add(event);
  events_.push_back(event);
}

void TablesHdf5Sink::on_odometry(const OdometryFrame& frame) {
  file_.append(odometry_.stamp, std::vector<double>{seconds(frame.odometry.stamp)});
  file_.append(odometry_.pose, numbers(frame.odometry.T_odom_base));
  file_.append(odometry_.truth, numbers(T_map_base_of(frame.true_pose)));
  const auto above = height_roll_pitch(T_footprint_base_of(frame.true_pose));
  if (!above) return;
  if (odometry_.above < 0) odometry_.above = add_height("/odometry/true_height_roll_pitch");
  file_.append(odometry_.above, numbers(*above));
}

int TablesHdf5Sink::add_height(const std::string& path) {
  return file_.add({path, Type::kFloat64, 3, kHeightUnit,
                    "true z, roll, pitch of base in map then: R_z(yaw) R_y(pitch) R_x(roll)"});
}

void TablesHdf5Sink::add_beams(const std::string& group, const ScanRecord& record,
                               LidarTables& tables) {
  const auto beams = static_cast<int>(record.scan.ranges.size());
  tables.ranges = file_.add({group + "/ranges", Type::kFloat32, beams, "m",
                             "scan by beam; inf: no return, -inf: too close"});
  tables.classes = file_.add({group + "/classes", Type::kUint8, beams, "",
                              "scan by beam: what it met, an index into /classes"});
  tables.hits = file_.add({group + "/hits", Type::kInt32, beams, "",
                           "scan by beam: number of the person, or of the object in /objects; -1"});
  if (record.truth.intensities.empty()) return;
  tables.intensities =
      file_.add({group + "/intensities", Type::kFloat32, beams, "", "scan by beam"});
}

void TablesHdf5Sink::describe_lidar(const std::string& group, const ScanRecord& record) {
  const LaserScan& scan = record.scan;
  const Eigen::Vector3d mount = scan.T_base_laser.translation();
  const Eigen::Vector3d turn = roll_pitch_yaw(scan.T_base_laser.linear());
  const std::vector<std::pair<const char*, double>> numbers_of{
      {"angle_min_rad", scan.angle_min},
      {"angle_increment_rad", scan.angle_increment},
      {"time_increment_s", seconds(scan.time_increment)},
      {"range_min_m", scan.range_min},
      {"range_max_m", scan.range_max},
      {"mount_x_m", mount.x()},
      {"mount_y_m", mount.y()},
      {"mount_z_m", mount.z()},
      {"mount_roll_rad", turn.x()},
      {"mount_pitch_rad", turn.y()},
      {"mount_yaw_rad", turn.z()}};
  file_.set_attribute(group, "frame", record.truth.frame);
  for (const auto& [name, value] : numbers_of) file_.set_attribute(group, name, value);
}

TablesHdf5Sink::LidarTables TablesHdf5Sink::add_lidar(const ScanRecord& record) {
  const std::string group = group_of(record.scan.lidar);
  const auto add = [&](const char* name, Type type, int columns, const char* unit,
                       const char* meaning) {
    return file_.add({group + "/" + name, type, columns, unit, meaning});
  };
  LidarTables tables;
  tables.stamp = add("stamp_s", Type::kFloat64, 0, "s", "time of the first beam");
  tables.pose = add("pose", Type::kFloat64, 3, kPoseUnit, "true x, y, yaw of base in map then");
  if (record.has_heights()) tables.above = add_height(group + "/height_roll_pitch");
  tables.odometry = add("odometry", Type::kFloat64, 3, kPoseUnit,
                        "x, y, yaw of base in odom, the newest when the scan is there");
  tables.since_kidnap = add("since_kidnap_s", Type::kFloat64, 0, "s", "since the last; NaN: none");
  tables.held = add("held", Type::kUint8, 0, "", "1: in somebody's hands");
  tables.torn = add("torn", Type::kUint8, 0, "", "1: a kidnap falls within the scan");
  tables.occluded =
      add("occluded", Type::kFloat32, 0, "1", "share of beams on what the map does not show");
  tables.ambiguity = add("ambiguity", Type::kFloat32, 0, "1",
                         "likeness of the place most like this; NaN: unknown");
  if (!localizers_.empty()) {
    tables.lost =
        add("lost", Type::kUint8, static_cast<int>(localizers_.size()), "",
            "scan by localizer of /localizers: 1 from 0.5 m or 0.35 rad on; 255: unknown");
  }
  add_beams(group, record, tables);
  describe_lidar(group, record);
  return tables;
}

void TablesHdf5Sink::write_people(const ScanRecord& record) {
  for (const PersonTruth& person : record.people.people) {
    file_.append(people_.stamp, std::vector<double>{seconds(record.stamp)});
    file_.append(people_.id, std::vector<std::int32_t>{person.id});
    file_.append(people_.pose, numbers(person.T_map_person));
    file_.append(people_.velocity, std::vector<double>{person.velocity.x(), person.velocity.y()});
    file_.append(people_.gap, std::vector<double>{person.gap_m});
  }
}

void TablesHdf5Sink::on_scan(const ScanRecord& record) {
  const ScanRow row = labeller_.row_of(record);
  const auto [found, first] = lidars_.try_emplace(record.scan.lidar);
  if (first) found->second = add_lidar(record);
  const LidarTables& tables = found->second;
  const auto flag = [](bool on) {
    return std::vector<std::uint8_t>{on ? std::uint8_t{1} : std::uint8_t{0}};
  };
  file_.append(tables.stamp, std::vector<double>{row.stamp_s});
  file_.append(tables.pose, numbers(row.T_map_base));
  if (const auto above = height_roll_pitch(T_footprint_base_of(record.true_pose))) {
    file_.append(tables.above, numbers(*above));
  }
  file_.append(tables.odometry, numbers(row.T_odom_base));
  file_.append(tables.since_kidnap, number(row.since_kidnap_s));
  file_.append(tables.held, flag(row.held));
  file_.append(tables.torn, flag(row.torn));
  file_.append(tables.occluded, std::vector<double>{row.occluded});
  file_.append(tables.ambiguity, number(row.ambiguity));
  if (!localizers_.empty()) {
    std::vector<std::uint8_t> lost = row.lost;
    lost.resize(localizers_.size(), kNobodyKnows);
    file_.append(tables.lost, lost);
  }
  file_.append(tables.ranges, record.scan.ranges);
  file_.append(tables.classes, row.classes);
  file_.append(tables.hits, row.hits);
  if (tables.intensities >= 0) file_.append(tables.intensities, record.truth.intensities);
  write_people(record);
}

void TablesHdf5Sink::write_events() {
  const int stamp = file_.add({"/events/stamp_s", Type::kFloat64, 0, "s", "when it was over"});
  const int begun = file_.add({"/events/begun_s", Type::kFloat64, 0, "s", "when it began"});
  const int from = file_.add(
      {"/events/from", Type::kFloat64, 3, kPoseUnit, "true x, y, yaw of base in map before"});
  const int to = file_.add(
      {"/events/to", Type::kFloat64, 3, kPoseUnit, "true x, y, yaw of base in map after"});
  std::vector<std::string> kinds;
  std::vector<std::string> details;
  for (const RunEvent& event : events_) {
    file_.append(stamp, std::vector<double>{seconds(event.stamp)});
    file_.append(begun, std::vector<double>{seconds(event.begun())});
    file_.append(from, numbers(event.T_map_from));
    file_.append(to, numbers(event.T_map_to));
    EventNames names = names_of(event.what);
    kinds.push_back(std::move(names.kind));
    details.push_back(std::move(names.detail));
  }
  file_.write_texts("/events/kind", kinds);
  file_.write_texts("/events/detail", details);
}

void TablesHdf5Sink::write_legend() {
  std::vector<std::string> classes;
  for (int i = 0; i < kBeamClasses; ++i) {
    classes.emplace_back(class_name(static_cast<BeamClass>(i)));
  }
  file_.write_texts("/classes", classes);
  file_.write_texts("/localizers", localizers_);
  const int ids = file_.add({"/objects/id", Type::kInt32, 0, "", "as in hits"});
  const int kinds = file_.add({"/objects/class", Type::kUint8, 0, "", "an index into /classes"});
  std::vector<std::string> names;
  for (const auto& [label, entry] : context_->legend.entries) {
    file_.append(ids, std::vector<std::int32_t>{label});
    file_.append(kinds, std::vector<std::uint8_t>{static_cast<std::uint8_t>(entry.of)});
    names.push_back(entry.name);
  }
  file_.write_texts("/objects/name", names);
}

void TablesHdf5Sink::finish(Stamp, const RunTiming&) {
  write_events();
  write_legend();
  file_.close();
}

}  // namespace castaway::testbed
