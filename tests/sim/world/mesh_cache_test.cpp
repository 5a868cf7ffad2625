#include "sim/world/mesh_cache.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/world/mesh_file.hpp"

namespace castaway::sim {
namespace {

namespace fs = std::filesystem;

class MeshCacheTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "other");
  }
  std::string file(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  TriangleMesh read(const std::string& path) {
    ++reads_;
    if (fail_) throw std::runtime_error(path + ": broken");
    if (too_large_) throw std::length_error(path + ": too large");
    return {{Eigen::Vector3f::Ones()}, {}, {}, {0, 0, 0}};
  }
  TriangleMesh get(const std::string& path) {
    return cache_.get(path, [this](const std::string& p) { return read(p); });
  }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("castaway-mesh-cache-") +
                      testing::UnitTest::GetInstance()->current_test_info()->name());
  MeshCache cache_{1000};
  int reads_ = 0;
  bool fail_ = false;
  bool too_large_ = false;
};

TEST_F(MeshCacheTest, ReadsFilesOfTheSameContentOnce) {
  EXPECT_EQ(get(file("a.stl", "solid")).vertices.size(), 1U);
  EXPECT_EQ(get(file("a.stl", "solid")).vertices.size(), 1U);
  EXPECT_EQ(get(file("other/b.stl", "solid")).indices.size(), 3U);
  EXPECT_EQ(reads_, 1);
}

TEST_F(MeshCacheTest, ReadsWhatHasChanged) {
  (void)get(file("a.stl", "solid"));
  (void)get(file("a.stl", "solid two"));
  (void)get(file("a.ply", "solid"));
  EXPECT_EQ(reads_, 3);
}

TEST_F(MeshCacheTest, TellsFilesApartThatHaveMaterialsBesideThem) {
  (void)get(file("a.obj", "mtllib a.mtl"));
  (void)get(file("other/a.obj", "mtllib a.mtl"));
  (void)get(file("b.obj", "mtllib a.mtl"));
  EXPECT_EQ(reads_, 2);
}

TEST_F(MeshCacheTest, RemembersFailuresUnderEveryName) {
  fail_ = true;
  EXPECT_THROW((void)get(file("a.stl", "solid")), std::runtime_error);
  try {
    (void)get(file("b.stl", "solid"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), (folder_ / "b.stl").string() + ": broken");
  }
  fail_ = false;
  too_large_ = true;
  EXPECT_THROW((void)get(file("c.stl", "c")), std::length_error);
  EXPECT_THROW((void)get(file("c.stl", "c")), std::length_error);
  EXPECT_EQ(reads_, 2);
}

TEST_F(MeshCacheTest, ForgetsOverItsLimit) {
  for (int i = 0; i < 20; ++i) (void)get(file("a.stl", std::to_string(i)));
  (void)get(file("a.stl", "0"));
  EXPECT_EQ(reads_, 21);
}

TEST_F(MeshCacheTest, ReadsNothingOfAHugeFile) {
  const std::string path = file("huge.stl", "x");
  fs::resize_file(path, kMaxMeshBytes + 1);
  (void)get(path);
  (void)get(path);
  EXPECT_EQ(reads_, 2);  // Its content would be its key.
}

TEST_F(MeshCacheTest, LeavesWhatIsNoFileToTheReader) {
  (void)get(folder_.string());
  (void)get((folder_ / "gone.stl").string());
  EXPECT_EQ(reads_, 2);
}

}  // namespace
}  // namespace castaway::sim
