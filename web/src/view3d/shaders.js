// GLSL of the 3-D view. Light is that of the pictures (sim/render/light_shaders.hpp), whose shadows and ambient occlusion
// are rendered once for the world, as it stands still. Meshes of several copies have no matrix of their own.

/** Towards the sun, as sim/scene/light_frame.cpp has it. */
export const kToSun = [-0.45, -0.6, 1.2].map((value) => value / Math.hypot(0.45, 0.6, 1.2));

const kLight = `
uniform vec3 eye;
uniform vec3 toSun;
uniform float brightness;
/** Light on a surface that sees \`open\` of the sky and \`sun\` of the sun. */
vec3 lightOn(vec3 n, vec3 toViewer, float open, float sun) {
  vec3 light = mix(vec3(0.36, 0.35, 0.34), vec3(0.52, 0.54, 0.57), 0.5 + 0.5 * n.z) * open;
  light += vec3(0.50, 0.48, 0.45) * max(dot(n, toSun), 0.0) * sun * (0.5 + 0.5 * open);
  return brightness * (light + vec3(0.08) * dot(n, toViewer) * open);
}`;

/** PLAIN: light of corners, not of pixels, and what stands on the floor receives no shadows. */
export const kLitVertex = `
invariant gl_Position;
#ifdef PLAIN
${kLight}
#endif
varying vec3 mapPosition;
varying vec3 mapNormal;
varying vec3 ownColor;
void main() {
  ownColor = color;
  vec4 p = vec4(position, 1.0);
#ifdef USE_INSTANCING
  p = instanceMatrix * p;
  mapNormal = mat3(instanceMatrix) * normal;
#else
  p = modelMatrix * p;
  mapNormal = mat3(modelMatrix) * normal;
#endif
#ifdef USE_INSTANCING_COLOR
  ownColor *= instanceColor;
#endif
  mapPosition = p.xyz;
#ifdef PLAIN
  vec3 toViewer = normalize(eye - mapPosition);
  vec3 n = normalize(mapNormal);
  if (dot(n, toViewer) < 0.0) n = -n;
  ownColor *= lightOn(n, toViewer, 0.97 - 0.05 / (0.2 + max(mapPosition.z, 0.0)), 1.0);
#endif
  gl_Position = projectionMatrix * (viewMatrix * p);
}`;

/** Sun, sky and floor, and a little light from the viewer; \`surroundings\`: r: open share of the sky, g: height of the top
 *  surface as a share of \`top\`. */
export const kLitFragment = `
uniform float ceiling;
varying vec3 mapPosition;
#ifdef PLAIN
varying vec3 ownColor;
void main() {
  if (mapPosition.z > ceiling) discard;
  gl_FragColor = vec4(ownColor, 1.0);
}
#else
${kLight}
uniform sampler2DShadow shadowMap;
uniform mat4 shadowFromMap;
uniform float shadowTexel;
uniform sampler2D surroundings;
uniform vec4 extent;
uniform float top;
varying vec3 mapNormal;
varying vec3 ownColor;
float openSky(vec3 n) {
  vec2 at = (mapPosition.xy + 0.07 * n.xy - extent.xy) / (extent.zw - extent.xy);
  vec2 there = texture(surroundings, at).rg;
  float above = mapPosition.z - there.g * top;
  float far = 1.0 + 2.0 * max(above, 0.0);
  if (above < -0.06) return n.z > 0.5 ? 0.55 : 0.85;  // Below something, or beside it.
  return 1.0 - (1.0 - there.r) / (far * far);
}
float sunlight(vec3 n, float facing) {
  vec3 at = (shadowFromMap * vec4(mapPosition + shadowTexel * (2.5 - 2.0 * facing) * n, 1.0)).xyz;
  return texture(shadowMap, at);
}
void main() {
  if (mapPosition.z > ceiling) discard;
  vec3 toViewer = normalize(eye - mapPosition);
  vec3 n = normalize(mapNormal);
  if (dot(n, toViewer) < 0.0) n = -n;
  float facing = dot(n, toSun);
  float sun = facing > 0.0 ? mix(0.25, 1.0, sunlight(n, facing)) : 0.0;
  gl_FragColor = vec4(ownColor * lightOn(n, toViewer, openSky(n), sun), 1.0);
}
#endif`;

/** Nothing but the depth of what is below the ceiling. [m] */
export const kDepthFragment = `
uniform float ceiling;
varying vec3 mapPosition;
void main() {
  if (mapPosition.z > ceiling) discard;
  gl_FragColor = vec4(1.0);
}`;

/** The floor, whose light is a picture. */
export const kFloorVertex = `
varying vec2 at;
void main() {
  at = uv;
  gl_Position = projectionMatrix * (viewMatrix * (modelMatrix * vec4(position, 1.0)));
}`;

export const kFloorFragment = `
uniform sampler2D picture;
uniform float brightness;
varying vec2 at;
void main() { gl_FragColor = vec4(brightness * texture(picture, at).rgb, 1.0); }`;

/** A ghost: one colour, lit from the viewer, brighter towards its outline. */
export const kGhostFragment = `
uniform vec3 eye;
uniform vec3 tint;
uniform float opacity;
varying vec3 mapPosition;
varying vec3 mapNormal;
varying vec3 ownColor;
void main() {
  vec3 toViewer = normalize(eye - mapPosition);
  float facing = abs(dot(normalize(mapNormal), toViewer));
  float shade = dot(ownColor, vec3(0.3, 0.6, 0.1));
  vec3 body = tint * (0.45 + 0.4 * facing + 0.35 * shade);
  gl_FragColor = vec4(mix(body, tint + 0.25, 0.6 * (1.0 - facing)), opacity * mix(1.5, 0.85, facing));
}`;

/** Flat signs on the floor: \`color.r\` is 1 for what has the sign's colour, 0 for its rim. */
export const kSignVertex = `
varying float own;
varying vec2 place;
void main() {
  vec4 p = vec4(position, 1.0);
#ifdef USE_INSTANCING
  p = instanceMatrix * p;
#endif
  own = 1.0;
#ifdef USE_COLOR
  own = color.r;
#endif
  place = position.xy;
  gl_Position = projectionMatrix * (viewMatrix * (modelMatrix * p));
}`;

export const kSignFragment = `
uniform vec3 tint;
uniform vec3 rim;
uniform float opacity;
varying float own;
varying vec2 place;
void main() {
  gl_FragColor = vec4(mix(rim, tint, own), opacity);
}`;

/** A soft shadow within the unit circle. */
export const kBlobFragment = `
varying vec2 place;
void main() {
  float rest = max(0.0, 1.0 - dot(place, place));
  gl_FragColor = vec4(0.0, 0.0, 0.0, 0.42 * rest * rest);
}`;

export const kPointVertex = `
uniform float size;
varying vec3 ownColor;
void main() {
  ownColor = color;
  gl_Position = projectionMatrix * (viewMatrix * vec4(position, 1.0));
  gl_PointSize = size;
}`;

export const kPointFragment = `
uniform float opacity;
varying vec3 ownColor;
void main() {
  vec2 at = 2.0 * gl_PointCoord - 1.0;
  if (dot(at, at) > 1.0) discard;
  gl_FragColor = vec4(ownColor, opacity);
}`;

export const kPlainVertex = `
void main() { gl_Position = projectionMatrix * (viewMatrix * (modelMatrix * vec4(position, 1.0))); }`;

export const kNothingFragment = `
void main() { gl_FragColor = vec4(1.0); }`;

/** Covers the whole picture with one triangle. */
export const kFillVertex = `
varying vec2 at;
void main() {
  at = 0.5 * position.xy + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

/** From heights seen from above: the open share of the sky, and the height. Higher ground within 0.6 m covers some of it. */
export const kSurroundingsFragment = `
uniform sampler2D heights;
uniform vec2 size;
varying vec2 at;
const float kReach = 0.6;
float heightAt(vec2 place) { return 1.0 - texture(heights, place).r; }
uniform float top;
void main() {
  float here = heightAt(at);
  float covered = 0.0;
  for (int i = 0; i < 80; ++i) {
    float radius = kReach * (0.08 + 0.92 * float(i) / 80.0);
    float angle = 2.3999632 * float(i);
    vec2 way = radius * vec2(cos(angle), sin(angle));
    float rise = max(0.0, (heightAt(at + way / size) - here) * top);
    covered += rise / sqrt(rise * rise + radius * radius) * (1.0 - radius / (1.15 * kReach));
  }
  gl_FragColor = vec4(max(0.25, 1.0 - 1.9 * covered / 80.0), here, 0.0, 1.0);
}`;
