#include "sim/world/sdf/load_sdf.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <sdf/sdf.hh>

#include "sim/world/footprint.hpp"
#include "sim/world/sdf/include_check.hpp"
#include "sim/world/sdf/scenery.hpp"
#include "sim/world/sdf/sdf_bodies.hpp"

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

constexpr double kFloor = 0.01;      // [m] What ends below is no obstacle.
constexpr double kMaxSide = 1000.0;  // [m]

/// libsdformat tells std::cerr what it also returns as errors; this keeps it to itself.
class Silence {
 public:
  Silence() : cerr_(std::cerr.rdbuf(nowhere_.rdbuf())) {}
  ~Silence() { std::cerr.rdbuf(cerr_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::ostringstream nowhere_;
  std::streambuf* cerr_;
};

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() > 400) text = text.substr(0, 400) + "...";
  return text;
}

sdf::ParserConfig quiet_config(const ResourceFinder& finder, const fs::path& folder) {
  sdf::Console::Instance()->SetQuiet(true);
  sdf::ParserConfig config;
  config.SetWarningsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetDeprecatedElementsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetFindCallback([&finder, folder](const std::string& uri) {
    return finder.model_file(finder.find(uri, folder)).string();
  });
  return config;
}

void throw_first(const sdf::Errors& errors, const std::string& path) {
  if (errors.empty()) return;
  const sdf::Error& error = errors.front();
  const std::string line = error.LineNumber() ? fmt::format(":{}", *error.LineNumber()) : "";
  throw std::runtime_error(fmt::format("{}{}: {}", path, line, one_line(error.Message())));
}

/// Masses are of no use here, and wrong ones would be errors.
void remove_masses(const sdf::ElementPtr& parent) {
  std::vector<sdf::ElementPtr> masses;
  for (sdf::ElementPtr e = parent->GetFirstElement(); e; e = e->GetNextElement()) {
    if (e->GetName() == "inertial") {
      masses.push_back(e);
    } else {
      remove_masses(e);
    }
  }
  for (const sdf::ElementPtr& mass : masses) parent->RemoveChild(mass);
}

/// The tree of a file, its includes taken in.
sdf::SDFPtr read_tree(const std::string& path, const sdf::ParserConfig& config) {
  auto tree = std::make_shared<sdf::SDF>();
  sdf::init(tree);
  sdf::Errors errors;
  const auto text = without_scenery(path);
  const bool read = text ? sdf::readString(*text, config, tree, errors)
                         : sdf::readFile(path, config, tree, errors);
  throw_first(errors, path);
  if (!read) throw std::runtime_error(path + ": is no SDF file");
  remove_masses(tree->Root());
  return tree;
}

/// libsdformat lets some numbers' own exceptions (`stoi`) through.
void load_tree(const std::string& path, const sdf::ParserConfig& config, sdf::Root& root) {
  try {
    throw_first(root.Load(read_tree(path, config), config), path);
  } catch (const std::logic_error& error) {
    throw std::runtime_error(
        fmt::format("{}: a number in it is out of range ({})", path, error.what()));
  }
}

bool is_floor(const WorldObject& object) { return bounds(object).max().z() <= kFloor; }

/// Just the geometry: a margin would be open ground all round it.
void set_extent(WorldSpec& spec, const std::string& path) {
  Eigen::AlignedBox3d box;
  for (const WorldObject& object : spec.objects) box.extend(bounds(object));
  const Eigen::Vector3d size = box.sizes();
  if (spec.objects.empty() || !(size.head<2>().minCoeff() > 0.0)) {
    throw std::runtime_error(fmt::format(
        "{}: nothing in it stands above the floor; there is nothing that a lidar could see", path));
  }
  if (!(size.head<2>().maxCoeff() <= kMaxSide)) {
    throw std::runtime_error(fmt::format("{}: {:.0f} m x {:.0f} m: at most 1000 m either way", path,
                                         size.x(), size.y()));
  }
  spec.min_corner = box.min().head<2>();
  spec.max_corner = box.max().head<2>();
}

}  // namespace

SdfWorld load_sdf(const std::string& path, const std::vector<std::string>& search_paths) {
  const ResourceFinder finder(path, search_paths);
  check_includes(path, finder);
  const Silence silence;
  sdf::Root root;
  const sdf::ParserConfig config = quiet_config(finder, fs::absolute(path).parent_path());
  load_tree(path, config, root);
  SdfBodies bodies(finder, path);
  SdfWorld result;
  result.spec.name = fs::path(path).stem().string();
  if (root.WorldCount() > 0) {
    const std::string& name = root.WorldByIndex(0)->Name();
    if (name != "default") result.spec.name = name;
    bodies.add(*root.WorldByIndex(0));
  } else if (root.Model() != nullptr) {
    bodies.add(*root.Model(), Eigen::Isometry3d::Identity());
  } else {
    throw std::runtime_error(path + ": holds neither a world nor a model");
  }
  result.warnings = bodies.warnings();
  for (WorldObject& object : bodies.take()) {
    if (!is_floor(object)) result.spec.objects.push_back(std::move(object));
  }
  set_extent(result.spec, path);
  return result;
}

}  // namespace castaway::sim
