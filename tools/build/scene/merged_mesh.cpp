#include "tools/build/scene/merged_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include <nlohmann/json.hpp>

#include "tools/base/formats/html.hpp"

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;

constexpr float kSame = 1e-4F;  // [m] Corners nearer than this are one.

/// A corner of an item, in the frame of all items.
struct Corner {
  Vector3f position;
  Vector3f normal;
  std::array<std::uint8_t, 3> color;
};

std::array<std::uint8_t, 3> color_bytes(const Vector3f& color) {
  std::array<std::uint8_t, 3> bytes{};
  for (int i = 0; i < 3; ++i) {
    bytes[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(color(i), 0.0F, 1.0F)));
  }
  return bytes;
}

std::array<std::int8_t, 3> to_bytes_signed(const Vector3f& normal) {
  std::array<std::int8_t, 3> bytes{};
  for (int i = 0; i < 3; ++i) {
    bytes[static_cast<std::size_t>(i)] =
        static_cast<std::int8_t>(std::lround(127.0F * std::clamp(normal(i), -1.0F, 1.0F)));
  }
  return bytes;
}

Corner corner_of(const sim::SceneItem& item, std::size_t index) {
  const sim::TriangleMesh& mesh = item.mesh;
  const Vector3f color =
      mesh.colors.empty() ? item.color : Vector3f(item.color.cwiseProduct(mesh.colors[index]));
  return {item.T_map_mesh * mesh.vertices[index], item.T_map_mesh.linear() * mesh.normals[index],
          color_bytes(color)};
}

/// Joins corners.
class Merger {
 public:
  explicit Merger(float cell)
      : cell_(std::max(cell, kSame)), per_unit_(cell > 0.0F ? 1.0F : 100.0F) {}

  void add(const sim::SceneItem& item) {
    std::vector<std::uint32_t> joined;
    joined.reserve(item.mesh.vertices.size());
    for (std::size_t i = 0; i < item.mesh.vertices.size(); ++i) {
      joined.push_back(join(corner_of(item, i)));
    }
    for (std::size_t i = 0; i + 2 < item.mesh.indices.size(); i += 3) {
      add_triangle(joined[item.mesh.indices[i]], joined[item.mesh.indices[i + 1]],
                   joined[item.mesh.indices[i + 2]]);
    }
  }

  MergedMesh take() {
    MergedMesh mesh;
    for (const Sum& sum : sums_) {
      mesh.positions.emplace_back(sum.position / static_cast<float>(sum.count));
      mesh.normals.push_back(to_bytes_signed(sum.normal.normalized()));
      mesh.colors.push_back(sum.color);
    }
    mesh.indices = std::move(indices_);
    return mesh;
  }

 private:
  /// Cube, direction and colour.
  using Key = std::array<int, 9>;
  struct Sum {
    Vector3f position = Vector3f::Zero();
    Vector3f normal = Vector3f::Zero();
    std::array<std::uint8_t, 3> color{};
    int count = 0;
  };

  std::uint32_t join(const Corner& corner) {
    Key key{};
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      key[axis] = static_cast<int>(std::lround(corner.position(i) / cell_));
      key[axis + 3] = static_cast<int>(std::lround(per_unit_ * corner.normal(i)));
      key[axis + 6] = corner.color[axis];
    }
    const auto [found, fresh] = numbers_.try_emplace(key, static_cast<std::uint32_t>(sums_.size()));
    if (fresh) sums_.push_back({.color = corner.color});
    Sum& sum = sums_[found->second];
    sum.position += corner.position;
    sum.normal += corner.normal;
    ++sum.count;
    return found->second;
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    indices_.insert(indices_.end(), {a, b, c});
  }

  float cell_;
  float per_unit_;  ///< Steps of a normal's components that are told apart.
  std::map<Key, std::uint32_t> numbers_;
  std::vector<Sum> sums_;
  std::vector<std::uint32_t> indices_;
};

template <typename Value>
std::string bytes_of(const std::vector<Value>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)});
}

}  // namespace

MergedMesh merge_items(const std::vector<sim::SceneItem>& items, float cell) {
  Merger merger(cell);
  for (const sim::SceneItem& item : items) merger.add(item);
  return merger.take();
}

nlohmann::ordered_json mesh_json(const MergedMesh& mesh) {
  return {{"positions", bytes_of(mesh.positions)},
          {"normals", bytes_of(mesh.normals)},
          {"colors", bytes_of(mesh.colors)},
          {"indices", bytes_of(mesh.indices)}};
}

std::size_t json_size(const MergedMesh& mesh) {
  constexpr std::size_t kCorner = sizeof(Vector3f) + 3 + 3;
  const std::size_t bytes =
      kCorner * mesh.positions.size() + sizeof(std::uint32_t) * mesh.indices.size();
  return bytes * 4 / 3 + 50;
}

}  // namespace castaway::testbed
