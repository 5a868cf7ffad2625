#include "sim/world/sdf/world_pieces.hpp"

#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/common/xml_text.hpp"
#include "sim/world/sdf/include_check.hpp"
#include "sim/world/sdf/model_spread.hpp"
#include "sim/world/sdf/scenery.hpp"

namespace castaway::sim {
namespace {

constexpr double kGroundPlane = 100.0;  // [m] Edge of the model `ground_plane`.

std::string child_text(const TiXmlElement& element, const char* name) {
  const TiXmlElement* child = element.FirstChildElement(name);
  const char* text = child == nullptr ? nullptr : child->GetText();
  return text == nullptr ? "" : text;
}

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
Ground ground_of(const TiXmlElement& include) {
  std::istringstream pose(child_text(include, "pose"));
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  pose >> p.x() >> p.y() >> p.z();
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * kGroundPlane);
  return {p.z(), Eigen::AlignedBox2d(p.head<2>() - half, p.head<2>() + half)};
}

std::string name_of(const TiXmlElement& element) {
  const std::string name =
      element.ValueStr() == "include" ? child_text(element, "name") : attribute(element, "name");
  return name.empty() ? child_text(element, "uri") : name;
}

/// Sorts the children of a world element.
class Cutter {
 public:
  Cutter(const std::string& path, const ResourceFinder& finder, const PiecePolicy& policy)
      : path_(path), policy_(policy), check_(path, finder) {}

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
  }

 private:
  void add_model(TiXmlElement& element, WorldPieces& world) {
    const bool included = element.ValueStr() == "include";
    const std::string uri = included ? child_text(element, "uri") : "";
    if (is_ground_plane(uri) && !world.ground) world.ground = ground_of(element);
    if (is_scenery(uri)) return;
    remove_unneeded(element);
    const TiXmlElement* pose = element.FirstChildElement("pose");
    if (pose != nullptr && !attribute(*pose, "relative_to").empty()) world.linked = true;
    if (!included) spread_.add(element);
    if (can_be_read(element)) world.pieces.push_back({name_of(element), text_of(element)});
  }

  bool can_be_read(const TiXmlElement& element) {
    try {
      check_.follow(element);
      return true;
    } catch (const std::runtime_error& error) {
      if (policy_.strict) {
        throw std::runtime_error(fmt::format("{}: {}: {}", path_, name_of(element), error.what()));
      }
      policy_.notes->leave_out(name_of(element), error);
      return false;
    }
  }

  const std::string& path_;
  const PiecePolicy& policy_;
  IncludeCheck check_;
  ModelSpread spread_;
};

}  // namespace

WorldPieces cut_world(const std::string& path, const std::string& text,
                      const ResourceFinder& finder, const PiecePolicy& policy) {
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
  Cutter cutter(path, finder, policy);
  if (inside == nullptr) {
    cutter.add(*root->FirstChildElement("model"), world);
    return world;
  }
  world.name = attribute(*inside, "name");
  for (TiXmlElement* element = inside->FirstChildElement(); element != nullptr;
       element = element->NextSiblingElement()) {
    cutter.add(*element, world);
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
