/// GLSL sources for light: shadows and ambient occlusion.
#pragma once

namespace castaway::sim {

/// Writes depth only.
inline constexpr const char* kEmptyFragmentShader = R"(#version 330 core
void main() {}
)";

/// Writes a mesh's normal, towards the viewer in eye coordinates, and its depth along the axis. [m]
inline constexpr const char* kSurfaceFragmentShader = R"(#version 330 core
in vec3 map_position;
in vec3 map_normal;
uniform vec4 viewpoint;
uniform mat4 eye_from_map;
out vec4 surface;
void main() {
  vec3 to_viewer = viewpoint.w > 0.5 ? normalize(viewpoint.xyz - map_position) : viewpoint.xyz;
  vec3 n = length(map_normal) > 0.0 ? normalize(map_normal) : to_viewer;
  if (dot(n, to_viewer) < 0.0) n = -n;
  float depth = -(eye_from_map * vec4(map_position, 1.0)).z;
  surface = vec4(mat3(eye_from_map) * n, depth);
}
)";

/// Draws a triangle over the whole picture, without vertices.
inline constexpr const char* kFillVertexShader = R"(#version 330 core
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

/// From surfaces, the share of the sky that is open, the share of the sun that is seen (faces
/// turned away from it: all), and the depth. `half_view`: half of the picture at the depth of 1 m
/// (perspective), or everywhere. [m]
inline constexpr const char* kLightFragmentShader = R"(#version 330 core
uniform sampler2D surface;
uniform sampler2DShadow shadow_map;
uniform vec2 half_view;
uniform float perspective;
uniform float pixels_per_m;
uniform float radius_m;
uniform mat4 map_from_eye;
uniform mat4 light_from_map;
uniform vec3 to_sun;
uniform float shadow_texel;
uniform float shadow_texel_m;
out vec4 light;
const int kSamples = 5;
const vec2 kSpiral[kSamples] = vec2[kSamples](
    vec2(0.1000, 0.0000), vec2(-0.2212, 0.2026), vec2(0.0437, -0.4981),
    vec2(0.4259, 0.5555), vec2(-0.8862, -0.1568));
vec3 eye_position(ivec2 at, float depth) {
  vec2 on_picture = (vec2(at) + 0.5) / vec2(textureSize(surface, 0)) * 2.0 - 1.0;
  return vec3(on_picture * half_view * mix(1.0, depth, perspective), -depth);
}
float open_sky(ivec2 at, vec4 here, vec3 p, mat2 turn) {
  ivec2 last = textureSize(surface, 0) - 1;
  float scale = pixels_per_m / mix(1.0, max(here.w, 0.01), perspective);
  float radius_px = clamp(radius_m * scale, 4.0, 40.0);
  float radius = radius_px / scale;
  float sum = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    vec2 offset = radius_px * (turn * kSpiral[i]);
    ivec2 there = clamp(at + ivec2(floor(offset + 0.5)), ivec2(0), last);
    float depth = texelFetch(surface, there, 0).w;
    vec3 v = eye_position(there, depth) - p;
    float vv = dot(v, v);
    float near = depth > 0.0 ? max(0.0, 1.0 - vv / (radius * radius)) : 0.0;
    sum += near * max(0.0, dot(v, here.xyz) * inversesqrt(vv + 1e-6) - 0.12);
  }
  return max(0.0, 1.0 - 1.6 * sum / float(kSamples));
}
float sunlight(vec3 p, vec3 n, mat2 turn) {
  float facing = dot(n, to_sun);
  vec3 from = p + shadow_texel_m * (2.5 - 2.0 * facing) * n;
  vec3 at = (light_from_map * vec4(from, 1.0)).xyz;
  vec2 rim = smoothstep(0.92, 1.0, abs(at.xy));
  at = 0.5 * at + 0.5;
  vec3 offset = vec3(shadow_texel * (turn * vec2(1.2, 0.4)), 0.0);
  float sum = textureLod(shadow_map, at + offset, 0.0) + textureLod(shadow_map, at - offset, 0.0);
  return facing > 0.0 ? max(0.5 * sum, max(rim.x, rim.y)) : 2.0;
}
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(surface, at, 0);
  vec3 p = eye_position(at, here.w);
  float angle = 0.6981317 * float(at.x % 3 + 3 * (at.y % 3));
  mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
  float open = open_sky(at, here, p, turn);
  float sun = sunlight((map_from_eye * vec4(p, 1.0)).xyz, mat3(map_from_eye) * here.xyz, turn);
  light = here.w > 0.0 ? vec4(open, sun, 0.0, here.w) : vec4(1.0, 1.0, 0.0, 0.0);
}
)";

/// Averages 3 x 3 pixels of similar depth. Where depths differ, shadow wins, so that no light leaks
/// under objects. Faces turned away from the sun (values above 1) are left out of its mean.
inline constexpr const char* kSmoothFragmentShader = R"(#version 330 core
uniform sampler2D raw;
out vec2 light;
void main() {
  ivec2 last = textureSize(raw, 0) - 1;
  ivec2 at = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(raw, at, 0).w;
  vec2 sky = vec2(0.0);
  vec2 sun = vec2(0.0);
  float darkest = 1.0;
  for (int i = 0; i < 9; ++i) {
    ivec2 place = clamp(at + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    vec4 there = texelFetch(raw, place, 0);
    float alike = step(abs(there.w - depth), 0.04 * depth + 0.02);
    float says = step(there.y, 1.0);
    sky += alike * vec2(there.x, 1.0);
    sun += alike * says * vec2(there.y, 1.0);
    darkest = min(darkest, mix(there.y, 1.0, max(alike, 1.0 - says)));
  }
  light = vec2(sky.x / sky.y, min(sun.y > 0.0 ? sun.x / sun.y : 1.0, darkest));
}
)";

/// Lights a surface by the sun, by sky and floor (less near other objects) and from the viewer; the
/// visible shares of sky and sun come from a smaller picture. A face turned away from the viewer is
/// lit like its other side, so that meshes with wrong normals stay readable.
inline constexpr const char* kLitFragmentShader = R"(#version 330 core
in vec3 map_position;
in vec3 map_normal;
in vec3 vertex_color;
uniform vec3 item_color;
uniform vec4 viewpoint;
uniform vec3 to_sun;
uniform sampler2D light_map;
uniform vec2 light_scale;
out vec4 pixel;
const float kShade = 0.25;
void main() {
  vec3 to_viewer = viewpoint.w > 0.5 ? normalize(viewpoint.xyz - map_position) : viewpoint.xyz;
  vec3 n = length(map_normal) > 0.0 ? normalize(map_normal) : to_viewer;
  if (dot(n, to_viewer) < 0.0) n = -n;
  vec2 seen = textureLod(light_map, gl_FragCoord.xy * light_scale, 0.0).rg;
  float sky = 0.5 + 0.5 * n.z;
  vec3 light = mix(vec3(0.36, 0.35, 0.34), vec3(0.52, 0.54, 0.57), sky) * seen.x;
  light += vec3(0.50, 0.48, 0.45) * max(dot(n, to_sun), 0.0) * mix(kShade, 1.0, seen.y) *
           (0.5 + 0.5 * seen.x);
  light += vec3(0.08) * max(dot(n, to_viewer), 0.0) * seen.x;
  pixel = vec4(item_color * vertex_color * light, 1.0);
}
)";

}  // namespace castaway::sim
