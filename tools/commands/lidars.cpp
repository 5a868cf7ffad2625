// castaway lidars: lists the lidar profiles that a scenario can use.
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/commands/commands.hpp"
#include "tools/scenario/sections/lidar_profile.hpp"

namespace castaway::testbed {
namespace {

double fov_deg(const sim::LidarConfig& lidar) {
  const double fov = lidar.angle_increment * (lidar.beams - 1) * 180.0 / std::numbers::pi;
  const double step = lidar.angle_increment * 180.0 / std::numbers::pi;
  return fov + step >= 360.0 - 1e-6 ? 360.0 : fov;
}

nlohmann::ordered_json to_json(const LidarProfile& profile, const sim::LidarConfig& lidar) {
  return {{"name", profile.name},
          {"device", profile.device},
          {"source", profile.source},
          {"beams", lidar.beams},
          {"layers", lidar.elevations.size()},
          {"fov_deg", fov_deg(lidar)},
          {"range_min_m", lidar.range_min},
          {"range_max_m", lidar.range_max},
          {"rate_hz", lidar.rate_hz},
          {"sigma_m", lidar.noise.sigma},
          {"sigma_relative", lidar.noise.sigma_relative},
          {"dark_range_m", lidar.light.dark_range}};
}

void print_row(const LidarProfile& profile, const sim::LidarConfig& lidar) {
  const std::string dark =
      lidar.light.dark_range > 0.0 ? fmt::format("{:g}", lidar.light.dark_range) : "-";
  print_out("{:<12} {:<32} {:>5} {:>6} {:>5.0f} {:>5g} {:>5g} {:>5g} {:>5g} {:>6g} {:>5}\n",
            profile.name, profile.device, lidar.beams, lidar.elevations.size(), fov_deg(lidar),
            lidar.range_min, lidar.range_max, lidar.rate_hz, 1e3 * lidar.noise.sigma,
            100.0 * lidar.noise.sigma_relative, dark);
}

int list_lidars(bool json) {
  auto list = nlohmann::ordered_json::array();
  if (!json) {
    print_out("{:<12} {:<32} {:>5} {:>6} {:>5} {:>5} {:>5} {:>5} {:>5} {:>6} {:>5}\n", "profile",
              "device", "beams", "layers", "deg", "min m", "max m", "Hz", "mm", "+ %", "dark");
  }
  for (const std::string& name : lidar_profile_names()) {
    const LidarProfile profile = load_lidar_profile(name);
    const sim::LidarConfig lidar = with_profile({}, name);
    if (json) {
      list.push_back(to_json(profile, lidar));
    } else {
      print_row(profile, lidar);
    }
  }
  if (json) {
    print_out("{}\n", json_text(list, 1));
  } else {
    print_out(
        "mm, + %: deviation of ranges, constant and with range; dark: metres to which a surface of "
        "reflectivity 0.1 is seen. Sources and estimates: in lidars/<profile>.yaml\n");
  }
  return kDone;
}

}  // namespace

void add_lidars_command(Command& app) {
  auto json = std::make_shared<bool>(false);
  Command command = app.add_command("lidars", "List the devices that a scenario can name");
  command.add_flag("--json", *json, "Print JSON instead of a table");
  command.footer("Example:\n  castaway lidars\n  castaway run --set lidar.profile=lds-01");
  command.action([json] { return list_lidars(*json); });
}

}  // namespace castaway::testbed
