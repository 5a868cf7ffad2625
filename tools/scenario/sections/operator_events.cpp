#include "tools/scenario/sections/operator_events.hpp"

#include <optional>

#include "tools/run/event_names.hpp"
#include "tools/scenario/sections/scenario.hpp"

namespace castaway::testbed {
namespace {

using What = LocalizerOrder::What;

/// Start pose of an order, and its uncertainty as that of a run's start.
void pose_fields(Settings& settings, LocalizerOrder& order) {
  std::optional<Eigen::Vector3d> pose;
  settings.optional(
      {"pose", "m, rad", "initialize: x, y, yaw of base in map.", {-kFarthest, kFarthest}}, pose);
  StartSpec start;
  settings.field({"sigma_m", "m", "initialize: stated uncertainty in x and y.", {0.0, 1e3}},
                 start.sigma_m);
  settings.field({"sigma_yaw", "rad", "initialize: stated uncertainty in yaw.", {0.0, 10.0}},
                 start.sigma_yaw);
  if (!pose) {
    if (!settings.describes()) settings.fail("an initial pose is missing: give 'pose'");
    return;
  }
  order.pose = {{pose->x(), pose->y(), pose->z()},
                Eigen::Vector3d(start.sigma_m * start.sigma_m, start.sigma_m * start.sigma_m,
                                start.sigma_yaw * start.sigma_yaw)
                    .asDiagonal()};
}

}  // namespace

void fields(Settings settings, sim::DriveCommand& command) {
  settings.field({"at_s", "s", "Simulated time.", {0.0, kLongest}}, command.at_s);
  std::optional<double> v;
  std::optional<double> w;
  settings.optional(
      {"v", "m/s", "Forward velocity; without v and w: by its route again.", {-100.0, 100.0}}, v);
  settings.optional({"w", "rad/s", "Turn rate, counter-clockwise.", {-100.0, 100.0}}, w);
  if (v || w) command.twist = sim::Twist2{v.value_or(0.0), w.value_or(0.0)};
}

void fields(Settings settings, LocalizerOrder& order) {
  double at_s = localization::seconds(order.at);
  settings.field({"at_s", "s", "Simulated time.", {0.0, kLongest}}, at_s);
  order.at = localization::from_seconds(at_s);
  settings.field({"name", "", "The localizer."}, order.localizer);
  settings.choice({"do", "", "What is done to it."}, order.what,
                  {{part_name(What::kInitialize), What::kInitialize},
                   {part_name(What::kRelocalize), What::kRelocalize},
                   {part_name(What::kOff), What::kOff},
                   {part_name(What::kOn), What::kOn}});
  if (settings.describes() || order.what == What::kInitialize) pose_fields(settings, order);
}

sim::DriveCommand read_drive_command(YamlReader body) {
  (void)body.require<double>("at_s");
  sim::DriveCommand command;
  fields(Settings::reading(body), command);
  return command;
}

LocalizerOrder read_localizer_order(YamlReader body) {
  for (const char* key : {"name", "do"}) (void)body.require<std::string>(key);
  (void)body.require<double>("at_s");
  LocalizerOrder order;
  fields(Settings::reading(body), order);
  return order;
}

}  // namespace castaway::testbed
