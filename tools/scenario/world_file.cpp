#include "tools/scenario/world_file.hpp"

#include <set>

#include "tools/scenario/world_objects.hpp"
#include "tools/scenario/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

void read_extent(YamlReader extent, sim::WorldSpec& spec) {
  spec.min_corner = extent.require<Eigen::Vector2d>("min");
  spec.max_corner = extent.require<Eigen::Vector2d>("max");
  if ((spec.max_corner - spec.min_corner).minCoeff() <= 0.0) {
    extent.fail("max must lie above and to the right of min");
  }
}

void read_objects(YamlReader& root, const std::filesystem::path& folder, sim::WorldSpec& spec) {
  std::set<std::string> names;
  std::size_t index = 0;
  for (YamlReader entry : root.list("objects")) {
    for (sim::WorldObject& object : read_world_object(entry, index++, folder)) {
      if (!names.insert(object.name).second) {
        entry.fail("the name '" + object.name + "' is taken; every object needs its own");
      }
      spec.objects.push_back(std::move(object));
    }
  }
}

std::vector<Eigen::Vector2d> read_route(const YamlReader& route) {
  std::vector<Eigen::Vector2d> points;
  for (const YamlReader& point : route.items()) points.push_back(point.as<Eigen::Vector2d>());
  if (points.size() < 2) route.fail("a route needs at least two points [x, y]");
  return points;
}

}  // namespace

WorldFile load_world(const std::filesystem::path& path) {
  const auto file = std::filesystem::is_directory(path) ? path / "world.yaml" : path;
  YamlDocument document = YamlDocument::load(file);
  YamlReader root = document.root();
  WorldFile world;
  world.spec.name = root.require<std::string>("name");
  read_extent(root.child("extent"), world.spec);
  const auto start = root.get<Eigen::Vector3d>("start", Eigen::Vector3d::Zero());
  world.start = {start.x(), start.y(), start.z()};
  if (const auto map = root.get_optional<std::string>("map")) {
    world.map = file.parent_path() / *map;
  }
  read_objects(root, file.parent_path(), world.spec);
  YamlReader routes = root.child("routes");
  for (const auto& [name, route] : routes.entries()) world.routes[name] = read_route(route);
  document.reject_unknown_keys();
  return world;
}

}  // namespace castaway::testbed
