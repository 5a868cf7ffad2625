#include "tools/ros/tf_tree.hpp"

namespace castaway::testbed {

bool TfTree::set_fixed(const std::string& parent, const std::string& child,
                       const Eigen::Isometry3d& T_parent_child) {
  const auto found = edges_.find(child);
  if (found != edges_.end() && found->second.fixed && found->second.parent == parent &&
      found->second.T_parent_child.matrix() == T_parent_child.matrix()) {
    return false;
  }
  edges_.insert_or_assign(child, Edge{parent, T_parent_child, true});
  return true;
}

void TfTree::add_moving(const std::string& parent, const std::string& child,
                        const Eigen::Isometry3d& T_parent_child) {
  edges_.try_emplace(child, Edge{parent, T_parent_child, false});
}

std::map<std::string, Eigen::Isometry3d> TfTree::up_from(const std::string& frame) const {
  std::map<std::string, Eigen::Isometry3d> T_ancestor_frame;
  std::string at = frame;
  Eigen::Isometry3d T_at_frame = Eigen::Isometry3d::Identity();
  while (T_ancestor_frame.try_emplace(at, T_at_frame).second) {
    const auto edge = edges_.find(at);
    if (edge == edges_.end()) break;
    at = edge->second.parent;
    T_at_frame = edge->second.T_parent_child * T_at_frame;
  }
  return T_ancestor_frame;
}

std::optional<Eigen::Isometry3d> TfTree::between(const std::string& a, const std::string& b) const {
  const auto T_ancestor_a = up_from(a);
  std::string at = b;
  Eigen::Isometry3d T_at_b = Eigen::Isometry3d::Identity();
  for (std::size_t steps = 0; steps <= edges_.size(); ++steps) {
    const auto common = T_ancestor_a.find(at);
    if (common != T_ancestor_a.end()) return common->second.inverse() * T_at_b;
    const auto edge = edges_.find(at);
    if (edge == edges_.end()) break;
    at = edge->second.parent;
    T_at_b = edge->second.T_parent_child * T_at_b;
  }
  return std::nullopt;
}

}  // namespace castaway::testbed
