#include "tools/scenario/sections/output_yaml.hpp"

#include <optional>

#include "tools/scenario/yaml/nearest.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {
namespace {

constexpr NumberRange kPixels{16.0, 4096.0};

void fields(Settings settings, PictureConfig& pictures) {
  settings.field(
      {"every_s", "s", "Time between two pictures; 0: no periodic pictures.", {0.01, 1e7, true}},
      pictures.every_s);
  settings.field({"on_events", "", "Pictures at kidnaps and recoveries."}, pictures.on_events);
  settings.field({"width", "px", "Width of each picture.", kPixels}, pictures.width);
  settings.field({"height", "px", "Height of each picture.", kPixels}, pictures.height);
}

void fields(Settings settings, FilmConfig& film) {
  settings.field({"width", "px", "Width; must be even.", kPixels}, film.format.width);
  settings.field({"height", "px", "Height; must be even.", kPixels}, film.format.height);
  settings.field({"fps", "1/s", "Frame rate.", {1.0, 120.0}}, film.format.fps);
  settings.field({"speed", "", "Seconds of the run per second of film.", {1e-3, 1e4}}, film.speed);
  settings.choice(
      {"view", "", "View of the film."}, film.view,
      {{"chase", FilmView::kChase}, {"overview", FilmView::kOverview}, {"map", FilmView::kMap}});
  if (film.format.width % 2 != 0 || film.format.height % 2 != 0) {
    settings.fail("'width' and 'height' must be even");
  }
}

void fields(Settings settings, BagOptions& bag) {
  settings.choice(
      {"compression", "", "Compression of the bag's chunks."}, bag.compression,
      {{"zstd", Compression::kZstd}, {"lz4", Compression::kLz4}, {"none", Compression::kNone}});
  settings.field({"particles", "", "All particles of all localizers."}, bag.particles);
  settings.field({"points", "", "Clouds with all layers of 3-D lidars."}, bag.points);
  settings.field({"clouds", "", "Scans and particles as clouds (PointCloud2), too."}, bag.clouds);
  settings.field({"snapshots", "", "The run's pictures, if it takes any."}, bag.snapshots);
}

void fields(Settings settings, CameraConfig& camera) {
  settings.field({"rate_hz", "Hz", "Pictures per second.", {1e-3, 100.0}}, camera.rate_hz);
  settings.field({"width", "px", "Width of each picture.", kPixels}, camera.width);
  settings.field({"height", "px", "Height of each picture.", kPixels}, camera.height);
  settings.field({"fov_deg", "deg", "Horizontal field of view.", {5.0, 150.0}}, camera.fov_deg);
  settings.field({"mount_xyz", "m", "Position of the optical centre in base.", {-100.0, 100.0}},
                 camera.p_base);
  settings.field({"mount_rpy", "rad", "Roll, pitch, yaw of the view in base.", {-100.0, 100.0}},
                 camera.rpy);
  settings.field({"depth", "", "Writes camera/depth."}, camera.depth);
  settings.field({"instances", "", "Writes camera/instances."}, camera.instances);
}

/// Reads `key: false`, `key: true`, or a map of changes to the defaults.
template <typename Config>
std::optional<Config> read_switch(YamlReader& map, const std::string& key) {
  const std::optional<YamlReader> given = map.find(key);
  if (!given || given->is_scalar()) {
    return map.get(key, false) ? std::optional(Config{}) : std::nullopt;
  }
  Config config;
  fields(Settings::reading(*given), config);
  return config;
}

void read_snapshots(YamlReader& map, OutputSpec& outputs) {
  const std::optional<YamlReader> scalar = map.find("snapshots");
  if (scalar && scalar->is_scalar()) {
    outputs.snapshots = scalar->as<bool>();
    return;
  }
  fields(Settings::reading(map.child("snapshots")), outputs.pictures);
}

void read_tables(YamlReader& map, OutputSpec& outputs) {
  const auto take = [&](const YamlReader& value) {
    const auto kind = value.as<std::string>();
    if (kind != "none" && kind != "csv" && kind != "hdf5") {
      value.fail("'" + kind + "' is not a kind of table; " +
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

void flag_fields(Settings& settings, OutputSpec& outputs) {
  settings.field({"report", "", "Writes report.html."}, outputs.report);
  settings.field({"player", "", "Puts the player into the report; writes recording.gz."},
                 outputs.player);
  settings.field({"scans", "", "Writes scans.csv and labels.csv."}, outputs.scans);
  settings.field({"carmen", "", "Writes log.carmen."}, outputs.carmen);
  settings.field({"kitti", "", "Writes kitti/."}, outputs.kitti);
  settings.field({"map", "", "Writes map/map.yaml and map/map.pgm."}, outputs.map);
}

}  // namespace

void describe_outputs(Settings settings) {
  OutputSpec outputs;
  flag_fields(settings, outputs);
  settings.form({"tables", "", "Tables of all scans: csv, hdf5, or a list of both."}, "none");
  settings.form({"points.every_s", "s", "Time between two PLY files of a lidar.", {0.01, 1e7}},
                "~");
  settings.form({"snapshots", "", "Pictures: false, or a map."}, "");
  fields(settings.group("snapshots"), outputs.pictures);
  fields(settings.group("video"), outputs.video);
  settings.form({"bag", "", "A bag of ROS 2 messages: true, or a map."}, "false");
  BagOptions bag;
  fields(settings.group("bag"), bag);
  settings.form({"camera", "", "A camera on the robot: true, or a map."}, "false");
  CameraConfig camera;
  fields(settings.group("camera"), camera);
}

OutputSpec read_outputs(YamlReader& root) {
  OutputSpec outputs;
  YamlReader map = root.child("outputs");
  Settings settings = Settings::reading(map);
  flag_fields(settings, outputs);
  read_tables(map, outputs);
  if (map.has("video")) fields(Settings::reading(map.child("video")), outputs.video);
  if (map.has("points")) {
    outputs.points_every_s = 1.0;
    Settings::reading(map.child("points"))
        .field({"every_s", "s", "", {0.01, 1e7}}, outputs.points_every_s);
  }
  outputs.bag = read_switch<BagOptions>(map, "bag");
  outputs.camera = read_switch<CameraConfig>(map, "camera");
  read_snapshots(map, outputs);
  return outputs;
}

}  // namespace castaway::testbed
