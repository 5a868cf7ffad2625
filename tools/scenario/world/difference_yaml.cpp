#include "tools/scenario/world/difference_yaml.hpp"

#include "tools/scenario/world/world_objects.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

using ChangeKind = sim::Change::Kind;

double share(YamlReader& map, const std::string& key) {
  const double value = map.get(key, 0.0);
  if (!(value >= 0.0 && value <= 1.0)) map.find(key)->fail("is a share: from 0 to 1");
  return value;
}

sim::Change read_change(YamlReader& entry, const std::filesystem::path& folder) {
  const std::vector<std::string> kinds = {"move", "remove", "open", "close", "add"};
  auto [kind, body] = entry.name_and_body();
  sim::Change change;
  if (kind == "add") {
    change.kind = ChangeKind::kAdd;
    change.objects = read_world_object(body, 0, folder).bodies;
    return change;
  }
  change.name = body.require<std::string>("name");
  if (kind == "remove") {
    change.kind = ChangeKind::kRemove;
  } else if (kind == "close") {
    change.kind = ChangeKind::kClose;
  } else if (kind == "open") {
    change.kind = ChangeKind::kOpen;
    change.open_deg = body.get("open_deg", change.open_deg);
  } else if (kind == "move") {
    change.by = body.get<Eigen::Vector2d>("by", change.by);
    change.turn_deg = body.get("turn_deg", change.turn_deg);
  } else {
    entry.fail("'" + kind + "' is no change; " + suggestion(kind, kinds));
  }
  return change;
}

}  // namespace

sim::DifferenceSpec read_differences(YamlReader& root, const std::filesystem::path& folder) {
  sim::DifferenceSpec spec;
  if (!root.has("differences")) return spec;
  YamlReader map = root.child("differences");
  spec.move_furniture = share(map, "move_furniture");
  spec.remove = share(map, "remove");
  spec.close_doors = share(map, "close_doors");
  spec.open_doors = share(map, "open_doors");
  spec.reach_m = map.get("reach_m", spec.reach_m);
  if (!(spec.reach_m > 0.0 && spec.reach_m <= 100.0)) {
    map.find("reach_m")->fail("must be above 0 and at most 100 m");
  }
  spec.add_boxes = map.get("add_boxes", spec.add_boxes);
  if (spec.add_boxes < 0 || spec.add_boxes > 1000) {
    map.find("add_boxes")->fail("must be from 0 to 1000");
  }
  spec.seed = map.get_optional<std::uint64_t>("seed");
  for (YamlReader entry : map.list("changes")) spec.changes.push_back(read_change(entry, folder));
  return spec;
}

}  // namespace castaway::testbed
