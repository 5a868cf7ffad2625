#include "sim/common/xml_pose.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace castaway::sim {
namespace {

std::vector<double> numbers(const std::string& text, std::size_t count) {
  std::vector<double> values(count, 0.0);
  std::istringstream words(text);
  std::string word;
  for (std::size_t i = 0; i < count && words >> word; ++i) {
    const double value = std::strtod(word.c_str(), nullptr);
    if (std::isfinite(value)) values[i] = value;
  }
  return values;
}

}  // namespace

std::string child_text(const TiXmlElement& element, const char* name) {
  const TiXmlElement* child = element.FirstChildElement(name);
  const char* text = child == nullptr ? nullptr : child->GetText();
  return text == nullptr ? "" : text;
}

Eigen::Vector3d child_vector(const TiXmlElement& element, const char* name) {
  const std::vector<double> v = numbers(child_text(element, name), 3);
  return {v[0], v[1], v[2]};
}

Eigen::Isometry3d child_pose(const TiXmlElement& element) {
  const std::vector<double> v = numbers(child_text(element, "pose"), 6);
  return Eigen::Translation3d(v[0], v[1], v[2]) *
         Eigen::AngleAxisd(v[5], Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(v[4], Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(v[3], Eigen::Vector3d::UnitX());
}

}  // namespace castaway::sim
