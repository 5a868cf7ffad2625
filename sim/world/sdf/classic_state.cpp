#include "sim/world/sdf/classic_state.hpp"

#include <algorithm>
#include <utility>

#include "sim/common/xml_pose.hpp"
#include "sim/world/sdf/flat_names.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

void add_places(const TiXmlElement& parent, const std::string& prefix, ClassicState& state) {
  for (auto* e = parent.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    const bool model = e->ValueStr() == "model";
    if (!model && e->ValueStr() != "link") continue;
    const std::string path = prefix + unscoped_name(attribute(*e, "name"));
    ClassicPlace place{child_pose(*e)};
    if (e->FirstChildElement("scale") != nullptr) place.scale = child_vector(*e, "scale");
    state.places.emplace(path, place);
    if (model) add_places(*e, path + "/", state);
  }
}

BoxShape scale_shape(BoxShape box, const Eigen::Vector3d& scale) {
  box.size = box.size.cwiseProduct(scale);
  return box;
}

CylinderShape scale_shape(CylinderShape cylinder, const Eigen::Vector3d& scale) {
  cylinder.radius *= scale.head<2>().maxCoeff();
  cylinder.height *= scale.z();
  return cylinder;
}

SphereShape scale_shape(SphereShape sphere, const Eigen::Vector3d& scale) {
  sphere.radius *= scale.maxCoeff();
  return sphere;
}

MeshShape scale_shape(MeshShape mesh, const Eigen::Vector3d& scale) {
  mesh.scale = scale;
  return mesh;
}

RampShape scale_shape(RampShape ramp, const Eigen::Vector3d& scale) {
  ramp.size = ramp.size.cwiseProduct(scale);
  return ramp;
}

}  // namespace

ClassicState read_classic_state(const TiXmlElement& element) {
  ClassicState state;
  add_places(element, "", state);
  const TiXmlElement* deletions = element.FirstChildElement("deletions");
  const TiXmlElement* name = deletions ? deletions->FirstChildElement("name") : nullptr;
  for (; name != nullptr; name = name->NextSiblingElement("name")) {
    if (name->GetText() != nullptr) state.deletions.insert(unscoped_name(name->GetText()));
  }
  return state;
}

ObjectShape scale_classic(const ObjectShape& shape, const Eigen::Vector3d& scale) {
  if (!(scale.minCoeff() > 0.0) || scale == Eigen::Vector3d::Ones()) return shape;
  return std::visit([&](const auto& s) -> ObjectShape { return scale_shape(s, scale); }, shape);
}

}  // namespace castaway::sim
