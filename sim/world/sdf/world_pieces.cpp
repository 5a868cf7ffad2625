#include "sim/world/sdf/world_pieces.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "sim/common/xml_pose.hpp"
#include "sim/world/sdf/flat_names.hpp"
#include "sim/world/sdf/include_check.hpp"
#include "sim/world/sdf/model_spread.hpp"
#include "sim/world/sdf/population.hpp"
#include "sim/world/sdf/scenery.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

constexpr double kGroundPlane = 100.0;  // [m] Edge of the model `ground_plane`.

std::string text_of(const TiXmlElement& element) {
  TiXmlDocument document;
  document.InsertEndChild(element);
  return xml_text_of(document);
}

void remove_unneeded(TiXmlElement& parent) {
  for (TiXmlElement* element = parent.FirstChildElement(); element != nullptr;) {
    TiXmlElement* next = element->NextSiblingElement();
    const bool scenery =
        element->ValueStr() == "include" && is_scenery(child_text(*element, "uri"));
    if (is_unneeded(element->ValueStr()) || scenery) {
      parent.RemoveChild(element);
    } else {
      remove_unneeded(*element);
    }
    element = next;
  }
}

/// Height and extent of an included ground plane.
Ground ground_of(const TiXmlElement& include, const ClassicState& state) {
  Eigen::Vector3d p = child_pose(include).translation();
  const std::string name = child_text(include, "name");
  const auto place = state.places.find(name.empty() ? "ground_plane" : unscoped_name(name));
  if (place != state.places.end()) p = place->second.T_world_body.translation();
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * kGroundPlane);
  return {p.z(), Eigen::AlignedBox2d(p.head<2>() - half, p.head<2>() + half)};
}

std::string name_of(const TiXmlElement& element) {
  const std::string name =
      element.ValueStr() == "include" ? child_text(element, "name") : attribute(element, "name");
  return name.empty() ? child_text(element, "uri") : name;
}

/// Gives a model of a population its name and its place.
TiXmlElement clone_model(const TiXmlElement& model, int number, const Eigen::Vector3d& p) {
  TiXmlElement clone(model);
  const std::string name = fmt::format("{}_clone_{}", attribute(model, "name"), number);
  clone.SetAttribute("name", name.c_str());
  for (auto* pose = clone.FirstChildElement("pose"); pose != nullptr;
       pose = clone.FirstChildElement("pose")) {
    clone.RemoveChild(pose);
  }
  TiXmlElement pose("pose");
  pose.InsertEndChild(TiXmlText(fmt::format("{} {} {} 0 0 0", p.x(), p.y(), p.z())));
  clone.InsertEndChild(pose);
  return clone;
}

/// Sorts the children of a world element.
class Cutter {
 public:
  Cutter(const std::string& path, const ResourceFinder& finder, const PiecePolicy& policy,
         const NamedStreams& streams)
      : path_(path), policy_(policy), streams_(streams), check_(path, finder) {}

  /// Lower bound for the size of the models added so far. [m]
  [[nodiscard]] Eigen::Vector2d size() const { return spread_.size(); }

  void add(TiXmlElement& element, WorldPieces& world) {
    const std::string& kind = element.ValueStr();
    if (kind == "frame" || kind == "joint") {
      remove_unneeded(element);
      world.frames += text_of(element);
      world.linked = true;
    }
    if (kind == "model" || kind == "include") add_model(element, world);
    if (kind == "population") populate(element, world);
    if (kind == "actor" || kind == "road") {
      policy_.notes->count_unread(kind + "s", attribute(element, "name"));
    }
  }

 private:
  void add_model(TiXmlElement& element, WorldPieces& world) {
    const bool included = element.ValueStr() == "include";
    const std::string uri = included ? child_text(element, "uri") : "";
    if (is_ground_plane(uri) && !world.ground) world.ground = ground_of(element, world.state);
    if (is_scenery(uri)) {
      world.left_out.insert({name_of(element), uri.substr(uri.rfind('/') + 1)});
      return;
    }
    remove_unneeded(element);
    unscope_names(element);
    const TiXmlElement* pose = element.FirstChildElement("pose");
    if (pose != nullptr && !attribute(*pose, "relative_to").empty()) world.linked = true;
    const bool moved = world.state.places.contains(name_of(element));
    if (!included && !moved) spread_.add(element);
    if (can_be_read(element)) {
      world.pieces.push_back({name_of(element), text_of(element)});
    } else {
      world.left_out.insert({name_of(element), uri.substr(uri.rfind('/') + 1)});
    }
  }

  /// Adds the models of a population. All are the same, so that only one is checked.
  void populate(TiXmlElement& population, WorldPieces& world) {
    const std::string name = attribute(population, "name");
    TiXmlElement* model = population.FirstChildElement("model");
    if (model == nullptr)
      return leave_out(name, std::runtime_error("its population has no <model>"));
    remove_unneeded(*model);
    unscope_names(*model);
    if (!can_be_read(*model)) return;
    Rng rng = streams_ ? streams_("population/" + name) : Rng();
    PopulationPlaces places;
    try {
      places = place_population(population, rng);
    } catch (const std::runtime_error& error) {
      return leave_out(name, error);
    }
    if (places.drawn) {
      policy_.notes->add(
          "Gazebo draws the places of these populations anew at each start, here they "
          "are the same in every run",
          name);
    }
    for (std::size_t i = 0; i < places.p_world.size(); ++i) {
      const TiXmlElement clone = clone_model(*model, static_cast<int>(i), places.p_world[i]);
      world.pieces.push_back({name_of(clone), text_of(clone)});
    }
  }

  void leave_out(const std::string& name, const std::runtime_error& error) const {
    if (policy_.strict) {
      throw std::runtime_error(fmt::format("{}: {}: {}", path_, name, error.what()));
    }
    policy_.notes->leave_out(name, error);
  }

  bool can_be_read(const TiXmlElement& element) {
    try {
      check_.follow(element);
      return true;
    } catch (const std::runtime_error& error) {
      leave_out(name_of(element), error);
      return false;
    }
  }

  const std::string& path_;
  const PiecePolicy& policy_;
  const NamedStreams& streams_;
  IncludeCheck check_;
  ModelSpread spread_;
};

}  // namespace

WorldPieces cut_world(const std::string& path, const std::string& text,
                      const ResourceFinder& finder, const PiecePolicy& policy,
                      const NamedStreams& streams) {
  const auto document = parse_xml(path, text);
  TiXmlElement* root = document->RootElement();
  if (root == nullptr || root->ValueStr() != "sdf") {
    throw std::runtime_error(path + ": not an SDF file: its root is not <sdf>");
  }
  WorldPieces world;
  const std::string version = attribute(*root, "version");
  if (!version.empty()) world.version = version;
  TiXmlElement* inside = root->FirstChildElement("world");
  if (inside == nullptr && root->FirstChildElement("model") == nullptr) {
    throw std::runtime_error(path + ": holds neither a world nor a model");
  }
  Cutter cutter(path, finder, policy, streams);
  if (inside == nullptr) {
    cutter.add(*root->FirstChildElement("model"), world);
    return world;
  }
  world.name = attribute(*inside, "name");
  TiXmlElement* state = inside->FirstChildElement("state");  // Gazebo classic applies the first.
  if (state != nullptr) world.state = read_classic_state(*state);
  TiXmlElement* insertions = state == nullptr ? nullptr : state->FirstChildElement("insertions");
  for (TiXmlElement* from : {inside, insertions}) {
    for (TiXmlElement* element = from == nullptr ? nullptr : from->FirstChildElement();
         element != nullptr; element = element->NextSiblingElement()) {
      cutter.add(*element, world);
    }
  }
  world.size = cutter.size();
  return world;
}

std::string sdf_text(const WorldPieces& world, std::size_t begin, std::size_t end) {
  std::string text =
      fmt::format("<?xml version='1.0'?>\n<sdf version='{}'>\n<world name='default'>\n{}",
                  world.version, world.frames);
  for (std::size_t i = begin; i < end; ++i) text += world.pieces[i].xml;
  return text + "</world>\n</sdf>\n";
}

}  // namespace castaway::sim
