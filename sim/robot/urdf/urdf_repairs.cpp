#include "sim/robot/urdf/urdf_repairs.hpp"

#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

std::string attribute_of(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? "" : value;
}

bool has_look(const TiXmlElement& material) {
  return material.FirstChildElement("color") != nullptr ||
         material.FirstChildElement("texture") != nullptr;
}

/// Names of the defined materials; removes repeated and empty definitions.
std::set<std::string> defined_materials(TiXmlElement& robot) {
  std::set<std::string> names;
  for (TiXmlElement* m = robot.FirstChildElement("material"); m != nullptr;) {
    TiXmlElement* next = m->NextSiblingElement("material");
    if (!has_look(*m) || !names.insert(attribute_of(*m, "name")).second) robot.RemoveChild(m);
    m = next;
  }
  // urdfdom keeps a material that a visual shape defines for all later ones.
  for (auto* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    for (auto* v = link->FirstChildElement("visual"); v != nullptr;
         v = v->NextSiblingElement("visual")) {
      const TiXmlElement* m = v->FirstChildElement("material");
      if (m != nullptr && has_look(*m)) names.insert(attribute_of(*m, "name"));
    }
  }
  return names;
}

void drop_unknown_materials(TiXmlElement& robot, std::vector<std::string>& warnings) {
  const std::set<std::string> known = defined_materials(robot);
  std::set<std::string> warned;
  for (auto* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    for (auto* v = link->FirstChildElement("visual"); v != nullptr;
         v = v->NextSiblingElement("visual")) {
      TiXmlElement* m = v->FirstChildElement("material");
      if (m == nullptr || has_look(*m) || known.contains(attribute_of(*m, "name"))) continue;
      if (warned.insert(attribute_of(*m, "name")).second) {
        warnings.push_back(fmt::format("link {}: no material '{}' is defined: grey is used",
                                       attribute_of(*link, "name"), attribute_of(*m, "name")));
      }
      v->RemoveChild(m);
    }
  }
}

void add_limits(TiXmlElement& robot, std::vector<std::string>& warnings) {
  for (auto* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const std::string type = attribute_of(*joint, "type");
    if (type != "revolute" && type != "prismatic") continue;
    TiXmlElement* limit = joint->FirstChildElement("limit");
    const bool whole = limit != nullptr && limit->Attribute("effort") != nullptr &&
                       limit->Attribute("velocity") != nullptr;
    if (whole) continue;
    if (limit == nullptr) {
      limit = joint->InsertEndChild(TiXmlElement("limit"))->ToElement();
    }
    for (const char* name : {"effort", "velocity"}) {
      if (limit->Attribute(name) == nullptr) limit->SetAttribute(name, "0");
    }
    warnings.push_back(fmt::format("joint {}: incomplete <limit>: missing values are 0",
                                   attribute_of(*joint, "name")));
  }
}

}  // namespace

void repair_urdf(TiXmlElement& robot, const std::string& path, std::vector<std::string>& warnings) {
  if (attribute_of(robot, "name").empty()) {
    const std::string stem = std::filesystem::path(path).stem().stem().string();
    robot.SetAttribute("name", stem);
    warnings.push_back(
        fmt::format("the robot has no name: it is called '{}' after its file", stem));
  }
  drop_unknown_materials(robot, warnings);
  add_limits(robot, warnings);
}

}  // namespace castaway::sim
