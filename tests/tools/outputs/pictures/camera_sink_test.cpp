#include "tools/outputs/pictures/camera_sink.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <png.h>
#include <nlohmann/json.hpp>

#include "sim/scene/primitives.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

sim::DeepImage read_deep(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0);
  header.format = PNG_FORMAT_LINEAR_Y;
  sim::DeepImage image{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) *
                      static_cast<std::size_t>(image.height));
  EXPECT_NE(png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr), 0);
  return image;
}

/// A camera half a metre above base that looks along x.
CameraConfig camera() {
  CameraConfig config;
  config.rate_hz = 10.0;
  config.width = 65;
  config.height = 49;
  config.fov_deg = 90.0;
  config.p_base = {0.0, 0.0, 0.5};
  return config;
}

/// A box of 1 m whose face is 2 m in front of the camera of a robot at the origin, and a person to
/// its left that comes from `moving`.
PictureWorld world() {
  const auto box = [](const Eigen::Vector3f& center, std::uint16_t instance) {
    sim::SceneItem item;
    item.mesh = sim::box_mesh({1.0F, 1.0F, 1.0F});
    item.T_map_mesh.translation() = center;
    item.instance = instance;
    return item;
  };
  PictureWorld world;
  world.world = {box({2.5F, 0.0F, 0.5F}, sim::kFirstObjectInstance)};
  world.moving = [box] {
    return std::vector<sim::SceneItem>{box({3.5F, 2.0F, 0.5F}, sim::kFirstPersonInstance + 1)};
  };
  return world;
}

class CameraSinkTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      sim::Renderer renderer(16, 16);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  void run(const CameraConfig& config) {
    CameraSink sink(folder_.path(), config, world(), {{sim::kFirstObjectInstance, "chest"}});
    for (int i = 0; i < 30; ++i) {
      sink.on_odometry({{milliseconds(20 * i), SE2{}}, SE2{}});
    }
    sink.finish(milliseconds(600), {});
  }

  std::filesystem::path at(const std::string& name) const {
    return folder_.path() / "camera" / name;
  }

  TemporaryFolder folder_;
};

TEST_F(CameraSinkTest, MeasuresDepthAlongTheAxis) {
  run(camera());
  const sim::DeepImage depth = read_deep(at("depth/000000.png"));
  const auto pixel = [&](int column, int row) {
    return depth.pixels[static_cast<std::size_t>(row * 65 + column)];
  };
  EXPECT_NEAR(pixel(32, 24), 2000, 2);
  EXPECT_NEAR(pixel(36, 28), 2000, 2);  // The face is flat: depth, not distance.
  EXPECT_EQ(pixel(64, 0), 0);
}

TEST_F(CameraSinkTest, TellsWhatEachPixelShows) {
  run(camera());
  const sim::DeepImage labels = read_deep(at("instances/000000.png"));
  EXPECT_EQ(labels.pixels[24 * 65 + 32], sim::kFirstObjectInstance);
  // The person's centre is 3 m ahead and 2 m to the left: u = cx - f * 2 / 3 at its face.
  const Intrinsics k = intrinsics(camera());
  const auto column = static_cast<std::size_t>(std::lround(k.cx - k.f * 2.0 / 3.0));
  EXPECT_EQ(labels.pixels[24 * 65 + column], sim::kFirstPersonInstance + 1);
  const auto named = nlohmann::json::parse(read_file(at("instances.json")));
  ASSERT_EQ(named.size(), 2U);
  EXPECT_EQ(named[0]["name"], "chest");
  EXPECT_EQ(named[1]["class"], "person");
  EXPECT_EQ(named[1]["name"], "person 1");
}

TEST_F(CameraSinkTest, TakesPicturesAtItsRateWithTheirPlaces) {
  run(camera());
  const CsvTable frames = read_csv(at("frames.csv"));
  ASSERT_EQ(frames.rows.size(), 6U);
  EXPECT_EQ(csv_number(frames.rows[5][frames.column("stamp_s")]), 0.5);
  EXPECT_EQ(csv_number(frames.rows[0][frames.column("z_m")]), 0.5);
  EXPECT_TRUE(std::filesystem::exists(at("rgb/000005.png")));
  const auto coco = nlohmann::json::parse(read_file(at("coco.json")));
  EXPECT_EQ(coco["images"].size(), 6U);
  EXPECT_EQ(coco["annotations"].size(), 6U);
  const auto json = nlohmann::json::parse(read_file(at("camera.json")));
  EXPECT_NEAR(json["fx"], 32.5, 1e-9);
  EXPECT_EQ(json["cx"], 32.0);
}

TEST_F(CameraSinkTest, StandsOnARampWithTheRobot) {
  PictureWorld raised = world();
  raised.T_footprint_base = [] { return Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.25)); };
  CameraSink sink(folder_.path(), camera(), raised, {});
  sink.on_odometry({{milliseconds(0), SE2{}}, SE2{}});
  sink.finish(milliseconds(600), {});
  const CsvTable frames = read_csv(at("frames.csv"));
  EXPECT_EQ(csv_number(frames.rows[0][frames.column("z_m")]), 0.75);
}

TEST_F(CameraSinkTest, LeavesOutWhatIsNotWanted) {
  CameraConfig config = camera();
  config.depth = false;
  config.instances = false;
  run(config);
  EXPECT_FALSE(std::filesystem::exists(at("depth")));
  EXPECT_FALSE(std::filesystem::exists(at("instances")));
  EXPECT_TRUE(std::filesystem::exists(at("coco.json")));
}

TEST(CameraConfig, KeepsItsOpticalFrame) {
  CameraConfig config = camera();
  config.rpy = {0.0, 0.0, std::numbers::pi / 2};  // Looks to the left.
  const Eigen::Isometry3d T = T_base_optical(config);
  EXPECT_LT((T.linear() * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((T.linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((T.linear() * Eigen::Vector3d::UnitY() + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(CameraConfig, ThatCannotBeIsRefused) {
  CameraConfig config = camera();
  config.fov_deg = 180.0;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = camera();
  config.width = 5;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = camera();
  config.rate_hz = 0.0;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::testbed
