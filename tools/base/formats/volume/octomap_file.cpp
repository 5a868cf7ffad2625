#include "tools/base/formats/volume/octomap_file.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <octomap/OcTree.h>

#include "localization/space/map3d/voxel_builder.hpp"

namespace castaway::testbed {
namespace {

using localization::VoxelBuilder;
using localization::VoxelMap;

constexpr int kFarthest = 1 << 15;  // [voxels] An OctoMap's keys have 16 bits.
constexpr double kMostOccupied = 1e7;

/// liboctomap prints when it reads or writes whole files, so that heads are read and written here.
std::string head_text(const octomap::OcTree& tree, OctomapKind kind) {
  return fmt::format(
      "# Octomap OcTree {}file\n# (feel free to add / change comments, but leave the first line as "
      "it is!)\n#\nid OcTree\nsize {}\nres {}\ndata\n",
      kind == OctomapKind::kBinary ? "binary " : "", tree.size(), tree.getResolution());
}

/// Reads the nodes of a tree that was checked.
void read_nodes(std::string_view bytes, const OctomapHead& head, const std::string& name,
                octomap::OcTree& tree) {
  if (head.nodes == 0) return;
  std::istringstream stream{std::string(bytes.substr(head.data))};
  if (head.kind == OctomapKind::kBinary) {
    tree.readBinaryData(stream);
  } else {
    tree.readData(stream);
  }
  if (!stream) throw std::runtime_error(name + ": liboctomap cannot read its tree");
}

/// Adds the centres of all voxels that a leaf covers; leaves above the finest level are pruned.
void add_leaf(const octomap::OcTree::leaf_iterator& leaf, double resolution,
              VoxelBuilder& builder) {
  const double edge = leaf.getSize();
  const auto across = static_cast<int>(std::lround(edge / resolution));
  const Eigen::Vector3d low(leaf.getX() - 0.5 * edge, leaf.getY() - 0.5 * edge,
                            leaf.getZ() - 0.5 * edge);
  for (int z = 0; z < across; ++z) {
    for (int y = 0; y < across; ++y) {
      for (int x = 0; x < across; ++x) {
        builder.add(low + Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5) * resolution);
      }
    }
  }
}

/// Throws std::invalid_argument, before they take memory: a node of a few bytes may be a large
/// cube.
void require_few_voxels(const octomap::OcTree& tree) {
  double count = 0.0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    const double across = leaf.getSize() / tree.getResolution();
    count += across * across * across;
    if (count > kMostOccupied) {
      throw std::invalid_argument("has more than 10 million occupied voxels; use larger voxels");
    }
  }
}

}  // namespace

std::string encode_octomap(const VoxelMap& map, OctomapKind kind) {
  octomap::OcTree tree(map.resolution);
  for (const localization::VoxelKey key : map.keys) {
    const Eigen::Vector3i voxel = localization::voxel_index(key);
    if ((voxel.array() < -kFarthest).any() || (voxel.array() >= kFarthest).any()) {
      throw std::invalid_argument(
          "the map reaches farther from its origin than OctoMap stores; use larger voxels");
    }
    const Eigen::Array3i biased = voxel.array() + kFarthest;
    tree.setNodeValue(octomap::OcTreeKey(static_cast<octomap::key_type>(biased.x()),
                                         static_cast<octomap::key_type>(biased.y()),
                                         static_cast<octomap::key_type>(biased.z())),
                      tree.getClampingThresMaxLog(), true);
  }
  tree.updateInnerOccupancy();
  if (kind == OctomapKind::kBinary) tree.prune();
  std::ostringstream stream;
  stream << head_text(tree, kind);
  if (tree.size() == 0) return std::move(stream).str();
  if (kind == OctomapKind::kBinary) {
    tree.writeBinaryData(stream);
  } else {
    tree.writeData(stream);
  }
  return std::move(stream).str();
}

VoxelMap decode_octomap(std::string_view bytes, const std::string& name) {
  const OctomapHead head = check_octomap(bytes, name);
  const double resolution = head.resolution;
  octomap::OcTree tree(resolution);
  read_nodes(bytes, head, name, tree);
  try {
    require_few_voxels(tree);
    VoxelBuilder builder(resolution);
    for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
      if (tree.isNodeOccupied(*leaf)) add_leaf(leaf, resolution, builder);
    }
    return builder.build();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

}  // namespace castaway::testbed
