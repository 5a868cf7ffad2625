#include "sim/world/sdf/read_elements.hpp"

#include <memory>

#include "sim/world/sdf/scenery.hpp"

namespace castaway::sim {
namespace {

void copy_values(const sdf::Element& from, sdf::Element& to) {
  to.SetName(from.GetName());
  to.SetRequired(from.GetRequired());
  to.SetCopyChildren(from.GetCopyChildren());
  to.SetReferenceSDF(from.ReferenceSDF());
  for (const sdf::ParamPtr& a : from.GetAttributes()) {
    to.AddAttribute(a->GetKey(), a->GetTypeName(), a->GetDefaultAsString(), a->GetRequired());
  }
  const sdf::ParamPtr value = from.GetValue();
  if (!value) return;
  to.AddValue(value->GetTypeName(), value->GetDefaultAsString(), value->GetRequired());
}

sdf::ElementPtr copy_needed(const sdf::Element& description) {
  auto copy = std::make_shared<sdf::Element>();
  copy_values(description, *copy);
  for (unsigned i = 0; i < description.GetElementDescriptionCount(); ++i) {
    const sdf::ElementPtr child = description.GetElementDescription(i);
    if (!is_unneeded(child->GetName())) copy->AddElementDescription(copy_needed(*child));
  }
  return copy;
}

}  // namespace

sdf::SDFPtr empty_sdf() {
  static const sdf::ElementPtr elements = [] {
    auto all = std::make_shared<sdf::SDF>();
    sdf::init(all);
    return copy_needed(*all->Root());
  }();
  auto tree = std::make_shared<sdf::SDF>();
  tree->Root(elements->Clone());
  return tree;
}

}  // namespace castaway::sim
