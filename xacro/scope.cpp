#include "xacro/scope.hpp"

namespace castaway::xacro {
namespace {

/// The innermost namespace of a name; nullptr if there is none.
Scope* find_namespace(Scope& scope, const std::string& name) {
  for (Scope* at = &scope; at != nullptr; at = at->parent) {
    const auto found = at->namespaces.find(name);
    if (found != at->namespaces.end()) return found->second.get();
  }
  return nullptr;
}

}  // namespace

Place resolve(Scope& scope, const std::string& dotted) {
  Place place{&scope, dotted};
  for (std::size_t dot = dotted.find('.'); dot != std::string::npos;) {
    Scope* inner = find_namespace(*place.scope, place.name.substr(0, place.name.find('.')));
    if (inner == nullptr) return place;
    place = {inner, place.name.substr(place.name.find('.') + 1)};
    dot = place.name.find('.');
  }
  return place;
}

Place find_property(Scope& scope, const std::string& dotted) {
  Place place = resolve(scope, dotted);
  while (place.scope != nullptr && !place.scope->properties.contains(place.name)) {
    place.scope = place.scope->parent;
  }
  return place;
}

const Block* find_block(Scope& scope, const std::string& name) {
  for (Scope* at = &scope; at != nullptr; at = at->parent) {
    const auto found = at->blocks.find(name);
    if (found != at->blocks.end()) return &found->second;
  }
  return nullptr;
}

const Macro* find_macro(Scope& scope, const std::string& name) {
  for (Scope* at = &scope; at != nullptr; at = at->parent) {
    const auto found = at->macros.find(name);
    if (found != at->macros.end()) return &found->second;
  }
  return nullptr;
}

std::vector<std::string> macro_names(const Scope& scope) {
  std::vector<std::string> names;
  for (const Scope* at = &scope; at != nullptr; at = at->parent) {
    for (const auto& [name, macro] : at->macros) names.push_back(name);
  }
  return names;
}

}  // namespace castaway::xacro
