/// The fixed part of a recorded frame tree.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <Eigen/Geometry>

namespace castaway::testbed {

class TfTree {
 public:
  /// Sets a fixed edge, replacing an older one. Returns true if this changes anything.
  bool set_fixed(const std::string& parent, const std::string& child,
                 const Eigen::Isometry3d& T_parent_child);
  /// Adds an edge that may move. Only its first value is kept, and only if the child has no edge
  /// yet.
  void add_moving(const std::string& parent, const std::string& child,
                  const Eigen::Isometry3d& T_parent_child);
  /// T_a_b via a common ancestor; nothing if there is none.
  [[nodiscard]] std::optional<Eigen::Isometry3d> between(const std::string& a,
                                                         const std::string& b) const;

 private:
  struct Edge {
    std::string parent;
    Eigen::Isometry3d T_parent_child;
    bool fixed = false;
  };
  /// T_ancestor_frame of the frame and all its ancestors; stops at loops.
  [[nodiscard]] std::map<std::string, Eigen::Isometry3d> up_from(const std::string& frame) const;

  std::map<std::string, Edge> edges_;
};

}  // namespace castaway::testbed
