#include "sim/world/sdf/flat_names.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

const std::string kSeparator = "::";
constexpr std::array<const char*, 5> kReferring{"relative_to", "attached_to", "placement_frame",
                                                "canonical_link", "expressed_in"};

bool is_scoped(const std::string& name) { return name.find(kSeparator) != std::string::npos; }

/// Renames an element and those in it; collects their former names.
void rename(TiXmlElement& element, std::vector<std::string>& names) {
  const std::string name = attribute(element, "name");
  if (is_scoped(name)) {
    names.push_back(name);
    element.SetAttribute("name", unscoped_name(name).c_str());
  }
  for (auto* e = element.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    rename(*e, names);
  }
}

/// A reference to a renamed element, or to something in it; others stay as they are.
std::string renamed(const std::string& reference, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (reference == name) return unscoped_name(name);
    if (reference.starts_with(name + kSeparator)) {
      return unscoped_name(name) + reference.substr(name.size());
    }
  }
  return reference;
}

void refer(TiXmlElement& element, const std::vector<std::string>& names) {
  for (const char* key : kReferring) {
    const std::string reference = attribute(element, key);
    if (is_scoped(reference)) element.SetAttribute(key, renamed(reference, names).c_str());
  }
  const bool of_joint = element.ValueStr() == "parent" || element.ValueStr() == "child";
  TiXmlNode* text = of_joint ? element.FirstChild() : nullptr;
  if (text != nullptr && text->ToText() != nullptr) text->SetValue(renamed(text->Value(), names));
  for (auto* e = element.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    refer(*e, names);
  }
}

}  // namespace

std::string unscoped_name(const std::string& name) {
  std::string plain = name;
  for (std::size_t at = plain.find(kSeparator); at != std::string::npos;
       at = plain.find(kSeparator)) {
    plain.replace(at, kSeparator.size(), "/");
  }
  return plain;
}

void unscope_names(TiXmlElement& model) {
  std::vector<std::string> names;
  rename(model, names);
  if (names.empty()) return;
  // The longest first: `a::b::c` may be a name of its own, or `c` in `a::b`.
  std::stable_sort(names.begin(), names.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  refer(model, names);
}

}  // namespace castaway::sim
