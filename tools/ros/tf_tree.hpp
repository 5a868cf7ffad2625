/// The fixed part of a recorded tree of frames.
#pragma once

#include <map>
#include <optional>
#include <string>

#include <Eigen/Geometry>

namespace castaway::testbed {

/// Edges by child.
class TfTree {
 public:
  /// A fixed edge; it takes the place of an older one. True if anything changed.
  bool set_fixed(const std::string& parent, const std::string& child,
                 const Eigen::Isometry3d& T_parent_child);
  /// An edge that may move: kept as it first was, where none is known.
  void add_moving(const std::string& parent, const std::string& child,
                  const Eigen::Isometry3d& T_parent_child);
  /// T_a_b by way of a common ancestor; nothing if there is none.
  [[nodiscard]] std::optional<Eigen::Isometry3d> between(const std::string& a,
                                                         const std::string& b) const;

 private:
  struct Edge {
    std::string parent;
    Eigen::Isometry3d T_parent_child;
    bool fixed = false;
  };
  /// T_ancestor_frame of the frame and all its ancestors; ends in loops, too.
  [[nodiscard]] std::map<std::string, Eigen::Isometry3d> up_from(const std::string& frame) const;

  std::map<std::string, Edge> edges_;
};

}  // namespace castaway::testbed
