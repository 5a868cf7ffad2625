#include "sim/world/sdf/model_spread.hpp"

#include <sstream>
#include <string>

namespace castaway::sim {
namespace {

/// What the elements in a model tell about the positions of its bodies.
struct Inside {
  double reach = 0.0;  ///< [m] Largest distance of any of its frames from the model's origin.
  bool solid = false;
  bool includes = false;
};

Eigen::Vector3d position_of(const TiXmlElement& pose) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  std::istringstream text(pose.GetText() == nullptr ? "" : pose.GetText());
  text >> p.x() >> p.y() >> p.z();
  return p;
}

/// True for a body whose shape is at its frame; a mesh need not be.
bool is_solid(const TiXmlElement& collision) {
  const TiXmlElement* geometry = collision.FirstChildElement("geometry");
  if (geometry == nullptr) return false;
  for (const char* shape : {"box", "cylinder", "sphere"}) {
    if (geometry->FirstChildElement(shape) != nullptr) return true;
  }
  return false;
}

void look_into(const TiXmlElement& parent, Inside& inside) {
  for (const TiXmlElement* element = parent.FirstChildElement(); element != nullptr;
       element = element->NextSiblingElement()) {
    const std::string& kind = element->ValueStr();
    if (kind == "pose") inside.reach += position_of(*element).norm();
    if (kind == "include") inside.includes = true;
    if (kind == "collision" && is_solid(*element)) inside.solid = true;
    look_into(*element, inside);
  }
}

}  // namespace

void ModelSpread::add(const TiXmlElement& model) {
  const TiXmlElement* pose = model.FirstChildElement("pose");
  if (pose != nullptr && pose->Attribute("relative_to") != nullptr) return;
  const Eigen::Vector3d p = pose == nullptr ? Eigen::Vector3d::Zero() : position_of(*pose);
  Inside inside;
  look_into(model, inside);
  if (pose != nullptr) inside.reach -= p.norm();
  if (!inside.solid || inside.includes || model.Attribute("placement_frame") != nullptr) return;
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(inside.reach);
  first_ = first_.cwiseMin(Eigen::Vector2d(p.head<2>()) + reach);
  last_ = last_.cwiseMax(Eigen::Vector2d(p.head<2>()) - reach);
}

}  // namespace castaway::sim
