/// GLSL sources of the renderer, except those for light.
#pragma once

namespace castaway::sim {

/// Meshes, with `position`, `normal` and `color` per vertex.
inline constexpr const char* kMeshVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
uniform mat4 clip_from_map;
uniform mat4 map_from_mesh;
out vec3 map_position;
out vec3 map_normal;
out vec3 vertex_color;
void main() {
  vec4 placed = map_from_mesh * vec4(position, 1.0);
  map_position = placed.xyz;
  map_normal = mat3(map_from_mesh) * normal;
  vertex_color = color;
  gl_Position = clip_from_map * placed;
}
)";

/// Draws meshes in their plain colour, without light.
inline constexpr const char* kPlainFragmentShader = R"(#version 330 core
in vec3 vertex_color;
uniform vec3 item_color;
out vec4 pixel;
void main() { pixel = vec4(item_color * vertex_color, 1.0); }
)";

/// Writes a mesh's depth along the optical axis, and its instance.
inline constexpr const char* kLabelFragmentShader = R"(#version 330 core
uniform float instance;
layout(location = 0) out float depth;
layout(location = 1) out uint label;
void main() {
  depth = 1.0 / gl_FragCoord.w;
  label = uint(instance + 0.5);
}
)";

/// Draws points and lines 5 cm nearer to the viewer, so that hits are not hidden by their surface.
inline constexpr const char* kOverlayVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 clip_from_map;
uniform vec4 viewpoint;
uniform float point_size;
void main() {
  vec3 to_viewer = viewpoint.w > 0.5 ? normalize(viewpoint.xyz - position) : viewpoint.xyz;
  gl_Position = clip_from_map * vec4(position + 0.05 * to_viewer, 1.0);
  gl_PointSize = point_size;
}
)";

/// `round_points` is 1 for points, 0 for lines.
inline constexpr const char* kOverlayFragmentShader = R"(#version 330 core
uniform vec3 item_color;
uniform float round_points;
out vec4 pixel;
void main() {
  vec2 from_center = gl_PointCoord - vec2(0.5);
  if (round_points > 0.5 && dot(from_center, from_center) > 0.25) discard;
  pixel = vec4(item_color, 1.0);
}
)";

}  // namespace castaway::sim
