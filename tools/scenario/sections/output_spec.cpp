#include "tools/scenario/sections/output_spec.hpp"

#include <optional>

#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

void read_snapshots(YamlReader& map, OutputSpec& outputs) {
  const std::optional<YamlReader> scalar = map.find("snapshots");
  if (scalar && scalar->is_scalar()) {
    outputs.snapshots = scalar->as<bool>();
    return;
  }
  YamlReader snapshots = map.child("snapshots");
  outputs.snapshot_every_s = snapshots.get("every_s", outputs.snapshot_every_s);
  if (!(outputs.snapshot_every_s >= 0.0)) snapshots.fail("'every_s' must not be negative");
  outputs.snapshot_on_events = snapshots.get("on_events", outputs.snapshot_on_events);
  outputs.snapshot_width = snapshots.get("width", outputs.snapshot_width);
  outputs.snapshot_height = snapshots.get("height", outputs.snapshot_height);
  for (const int size : {outputs.snapshot_width, outputs.snapshot_height}) {
    if (size < 16 || size > 4096) snapshots.fail("'width' and 'height' must be in 16..4096");
  }
}

VideoSpec read_video(YamlReader& map) {
  VideoSpec video;
  if (!map.has("video")) return video;
  YamlReader reader = map.child("video");
  video.width = reader.get("width", video.width);
  video.height = reader.get("height", video.height);
  for (const int size : {video.width, video.height}) {
    if (size < 16 || size > 4096 || size % 2 != 0) {
      reader.fail("'width' and 'height' must be even and in 16..4096");
    }
  }
  video.fps = reader.get("fps", video.fps);
  if (video.fps < 1 || video.fps > 120) reader.fail("'fps' must be in 1..120");
  video.speed = reader.get("speed", video.speed);
  if (!(video.speed > 0.0)) reader.fail("'speed' must be positive");
  video.view = reader.choice("view", video.view, {"chase", "overview", "map"});
  return video;
}

void read_tables(YamlReader& map, OutputSpec& outputs) {
  const auto take = [&](const YamlReader& value) {
    const auto kind = value.as<std::string>();
    if (kind != "none" && kind != "csv" && kind != "hdf5") {
      value.fail("'" + kind + "' is no kind of table; " +
                 suggestion(kind, {"csv", "hdf5", "none"}));
    }
    outputs.tables_csv = outputs.tables_csv || kind == "csv";
    outputs.tables_hdf5 = outputs.tables_hdf5 || kind == "hdf5";
  };
  const std::optional<YamlReader> list = map.find("tables");
  if (!list || !list->is_list()) {
    const std::string kind = map.get("tables", "none");
    if (kind != "none") take(*map.find("tables"));
    return;
  }
  for (const YamlReader& item : list->items()) take(item);
}

/// A flag, or a map of what differs from the defaults.
std::optional<BagSpec> read_bag(YamlReader& map) {
  const std::optional<YamlReader> given = map.find("bag");
  if (!given || given->is_scalar()) {
    return map.get("bag", false) ? std::optional(BagSpec{}) : std::nullopt;
  }
  YamlReader reader = map.child("bag");
  BagSpec bag;
  bag.compression = reader.choice("compression", bag.compression, {"zstd", "lz4", "none"});
  bag.particles = reader.get("particles", bag.particles);
  bag.snapshots = reader.get("snapshots", bag.snapshots);
  return bag;
}

std::optional<CameraSpec> read_camera(YamlReader& map) {
  const std::optional<YamlReader> given = map.find("camera");
  if (!given || given->is_scalar()) {
    return map.get("camera", false) ? std::optional(CameraSpec{}) : std::nullopt;
  }
  YamlReader reader = map.child("camera");
  CameraSpec camera;
  camera.rate_hz = reader.get("rate_hz", camera.rate_hz);
  if (!(camera.rate_hz > 0.0 && camera.rate_hz <= 100.0)) {
    reader.fail("'rate_hz' must be above 0 and at most 100");
  }
  camera.width = reader.get("width", camera.width);
  camera.height = reader.get("height", camera.height);
  for (const int size : {camera.width, camera.height}) {
    if (size < 16 || size > 4096) reader.fail("'width' and 'height' must be in 16..4096");
  }
  camera.fov_deg = reader.get("fov_deg", camera.fov_deg);
  if (!(camera.fov_deg >= 5.0 && camera.fov_deg <= 150.0)) {
    reader.fail("'fov_deg' must be in 5..150");
  }
  camera.mount_xyz = reader.get("mount_xyz", camera.mount_xyz);
  camera.mount_rpy = reader.get("mount_rpy", camera.mount_rpy);
  camera.depth = reader.get("depth", camera.depth);
  camera.instances = reader.get("instances", camera.instances);
  return camera;
}

}  // namespace

OutputSpec read_outputs(YamlReader& root) {
  OutputSpec outputs;
  YamlReader map = root.child("outputs");
  outputs.report = map.get("report", outputs.report);
  outputs.player = map.get("player", outputs.player);
  outputs.scans = map.get("scans", outputs.scans);
  read_tables(map, outputs);
  outputs.video = read_video(map);
  if (map.has("points")) {
    YamlReader points = map.child("points");
    outputs.points_every_s = points.get("every_s", 1.0);
    if (!(outputs.points_every_s > 0.0)) points.fail("'every_s' must be positive");
  }
  outputs.bag = read_bag(map);
  outputs.carmen = map.get("carmen", outputs.carmen);
  outputs.kitti = map.get("kitti", outputs.kitti);
  outputs.map = map.get("map", outputs.map);
  outputs.camera = read_camera(map);
  read_snapshots(map, outputs);
  return outputs;
}

}  // namespace castaway::testbed
