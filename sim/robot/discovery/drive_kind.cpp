#include "sim/robot/discovery/drive_kind.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include <fmt/format.h>

#include "sim/common/xml_pose.hpp"
#include "xacro/files/lower_case.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

constexpr double kUpright = 0.9;      // Cosine of the angle to an axis.
constexpr double kSameHeight = 0.5;   // Share of a wheel's radius.
constexpr double kBesideAxis = 0.05;  // [m]

constexpr double kSlides = 0.05;  // Less friction is none.
constexpr double kOblique = 0.3;  // Least component of the axis of a mecanum wheel's roller.

bool holds(const std::string& text, const char* word) {
  return text.find(word) != std::string::npos;
}

/// Names of the plug-ins below an element, in lower case, separated by blanks.
std::string plugin_names(const TiXmlElement& from) {
  std::string names;
  for (auto* e = from.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    if (e->ValueStr() == "plugin") {
      for (const char* key : {"name", "filename"}) {
        if (e->Attribute(key) != nullptr) names += to_lower(e->Attribute(key)) + " ";
      }
    }
    names += plugin_names(*e);
  }
  return names;
}

/// Names of a wheel's joint, link and meshes, in lower case.
std::string wheel_names(const UrdfFile& file, const DriveWheel& wheel) {
  std::string names = wheel.joint + " " + wheel.link;
  for (const auto& visual : file.model->links_.at(wheel.link)->visual_array) {
    const auto* mesh = dynamic_cast<const urdf::Mesh*>(visual->geometry.get());
    if (mesh != nullptr) names += " " + mesh->filename.substr(mesh->filename.rfind('/') + 1);
  }
  return to_lower(names);
}

/// True of a joint that turns a wheel about the vertical within limits, or whose name says "steer".
bool steers(const urdf::Joint& joint, const LinkFrames& frames) {
  if (joint.type != urdf::Joint::REVOLUTE && joint.type != urdf::Joint::CONTINUOUS) return false;
  if (holds(to_lower(joint.name), "steer")) return true;
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  const Eigen::Vector3d in_root = frames.at(joint.child_link_name).linear() * axis.normalized();
  return joint.type == urdf::Joint::REVOLUTE && std::abs(in_root.z()) > kUpright;
}

/// True if a joint between a wheel and the root steers it.
bool is_steered(const UrdfFile& file, const LinkFrames& frames, const std::string& wheel_link) {
  auto link = file.model->getLink(wheel_link);
  for (link = file.model->getLink(link->parent_joint->parent_link_name); link->parent_joint;
       link = file.model->getLink(link->parent_joint->parent_link_name)) {
    if (steers(*link->parent_joint, frames)) return true;
  }
  return false;
}

/// True if a joint turns like a driven wheel: about y, at the height of their axles.
bool turns_as_wheel(const urdf::Joint& joint, const LinkFrames& frames,
                    const std::vector<DriveWheel>& wheels) {
  const Eigen::Isometry3d& frame = frames.at(joint.child_link_name);
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  if (std::abs((frame.linear() * axis.normalized()).y()) < kUpright) return false;
  return std::any_of(wheels.begin(), wheels.end(), [&](const DriveWheel& wheel) {
    const double axle = frames.at(wheel.link).translation().z();
    return std::abs(frame.translation().z() - axle) < kSameHeight * wheel.radius;
  });
}

/// True if a joint may be that of a steered wheel; `names` are those of the joint and its link.
bool may_be_steered_wheel(const UrdfFile& file, const LinkFrames& frames, const urdf::Joint& joint,
                          const std::string& names) {
  const bool caster = holds(names, "caster") || holds(names, "castor");
  if (joint.type != urdf::Joint::CONTINUOUS || caster || steers(joint, frames)) return false;
  return is_steered(file, frames, joint.child_link_name);
}

/// True if any wheel is steered, also one that is not driven, as on a car's front axle. Since an
/// arm's joints turn about the vertical, too, a wheel must be named as one, or there must be one on
/// each side.
bool any_steered(const UrdfFile& file, const LinkFrames& frames,
                 const std::vector<DriveWheel>& wheels) {
  int named = 0;
  bool left = false;
  bool right = false;
  for (const auto& [name, joint] : file.model->joints_) {
    const std::string names = to_lower(name + " " + joint->child_link_name);
    if (!may_be_steered_wheel(file, frames, *joint, names)) continue;
    named += holds(names, "wheel") || holds(names, "tire") ? 1 : 0;
    if (!turns_as_wheel(*joint, frames, wheels)) continue;
    const double y = frames.at(joint->child_link_name).translation().y();
    left = left || y > kBesideAxis;
    right = right || y < -kBesideAxis;
  }
  return named >= 2 || (left && right);
}

/// True if a surface has no friction in one direction and an oblique one in the other, as rollers
/// at 45 degrees have. The axis may be given in any frame, so that any two components will do.
bool has_oblique_friction(const TiXmlElement& surface) {
  bool oblique = false;
  bool slides = false;
  const std::function<void(const TiXmlElement&)> look = [&](const TiXmlElement& from) {
    const Eigen::Vector3d axis = child_vector(from, "fdir1").normalized();
    oblique = oblique || (axis.cwiseAbs().array() > kOblique).count() >= 2;
    for (const char* key : {"mu", "mu1", "mu2"}) {
      const bool given = from.FirstChildElement(key) != nullptr;
      slides = slides || (given && child_vector(from, key).x() < kSlides);
    }
    for (auto* e = from.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) look(*e);
  };
  look(surface);
  return oblique && slides;
}

/// True if the friction of a driven wheel models rollers.
bool has_rollers(const UrdfFile& file, const std::vector<DriveWheel>& wheels) {
  const TiXmlElement& root = *file.xml->RootElement();
  for (auto* g = root.FirstChildElement("gazebo"); g != nullptr;
       g = g->NextSiblingElement("gazebo")) {
    const std::string of = attribute(*g, "reference");
    const bool wheel = std::any_of(wheels.begin(), wheels.end(), [&of](const DriveWheel& w) {
      return of == w.link || of == w.joint;
    });
    if (wheel && has_oblique_friction(*g)) return true;
  }
  return false;
}

/// Types of controllers in lower case, separated by blanks; empty if one is of a differential
/// drive.
std::string drive_controllers(const std::vector<std::string>& types) {
  std::string names;
  for (const std::string& type : types) names += to_lower(type) + " ";
  return holds(names, "diff_drive") ? "" : names;
}

bool holds_steering(const std::string& controllers) {
  for (const char* word : {"steering", "ackermann", "tricycle", "bicycle", "swerve"}) {
    if (holds(controllers, word)) return true;
  }
  return false;
}

}  // namespace

std::optional<OtherDrive> other_drive(const UrdfFile& file, const LinkFrames& frames,
                                      const std::vector<DriveWheel>& wheels,
                                      const std::vector<std::string>& controllers) {
  const std::string plugins = plugin_names(*file.xml->RootElement());
  const std::string types = drive_controllers(controllers);
  std::string names = types + plugins;
  for (const DriveWheel& wheel : wheels) names += wheel_names(file, wheel) + " ";
  if (holds(names, "mecanum") || has_rollers(file, wheels)) return OtherDrive::kMecanum;
  if (holds(names, "omni")) return OtherDrive::kOmni;
  if (any_steered(file, frames, wheels) || holds_steering(types)) return OtherDrive::kSteered;
  if (holds(plugins, "planar_move")) return OtherDrive::kPlanarMove;
  const std::string stem = std::filesystem::path(file.path).stem().string();
  const std::string robot = to_lower(file.model->getName() + " " + stem);
  if (holds(robot, "mecanum")) return OtherDrive::kMecanum;
  if (holds(robot, "omni")) return OtherDrive::kOmni;
  return std::nullopt;
}

std::string describe(OtherDrive drive) {
  switch (drive) {
    case OtherDrive::kMecanum:
      return "mecanum wheels";
    case OtherDrive::kOmni:
      return "omni wheels";
    case OtherDrive::kPlanarMove:
      return "a planar_move plug-in";
    case OtherDrive::kSteered:
      break;
  }
  return "steered wheels";
}

std::string other_drive_warning(OtherDrive drive, std::size_t wheels) {
  const char* here = wheels > 2 ? "skid steer" : "differential drive";
  if (drive == OtherDrive::kSteered) {
    return fmt::format(
        "moves by steered wheels: simulated as {} with the steering locked straight, which turns "
        "on the spot as the robot cannot",
        here);
  }
  return fmt::format("moves by {}: simulated as {}, which never moves sideways", describe(drive),
                     here);
}

}  // namespace castaway::sim
