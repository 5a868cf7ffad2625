#include "tools/build/isolated_meshes.hpp"

#include <sys/stat.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/world/mesh_file.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;
using testing::AllOf;
using testing::HasSubstr;

const MeshLimits kShort{milliseconds(1500), std::size_t{256} << 20U};

/// Error text for a mesh whose reader fails.
std::string said_of(const sim::MeshReader& read, const std::string& path = "a.stl") {
  try {
    (void)read_isolated(path, read, kShort);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing";
}

/// Checks that no child process is left.
void expect_no_children() {
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(IsolatedMeshes, GiveWhatTheReaderReads) {
  const std::string path = CASTAWAY_TEST_DATA "/meshes/cube.obj";
  const sim::TriangleMesh here = sim::read_mesh_file(path);
  const sim::TriangleMesh apart = read_isolated(path, sim::read_mesh_file);
  EXPECT_EQ(here.vertices, apart.vertices);
  EXPECT_EQ(here.normals, apart.normals);
  EXPECT_EQ(here.colors, apart.colors);
  EXPECT_EQ(here.indices, apart.indices);
  expect_no_children();
}

TEST(IsolatedMeshes, HandOnWhatTheReaderThrows) {
  const auto refuse = [](const std::string& path) -> sim::TriangleMesh {
    throw std::runtime_error(path + ": odd");
  };
  EXPECT_EQ(said_of(refuse), "a.stl: odd");
  EXPECT_THROW(
      (void)read_isolated(
          "a", [](const std::string&) -> sim::TriangleMesh { throw std::length_error("long"); }),
      std::length_error);
  expect_no_children();
}

TEST(IsolatedMeshes, SurviveACrash) {
  const auto crash = [](const std::string&) -> sim::TriangleMesh {
    std::raise(SIGSEGV);
    return {};
  };
  EXPECT_THAT(said_of(crash), AllOf(HasSubstr("a.stl: cannot read this mesh"), HasSubstr("Segm")));
  const auto leave = [](const std::string&) -> sim::TriangleMesh { std::_Exit(0); };
  EXPECT_THAT(said_of(leave), HasSubstr("a.stl: cannot read this mesh"));
  expect_no_children();
}

TEST(IsolatedMeshes, EndAReaderThatNeverDoes) {
  const auto sleep = [](const std::string&) -> sim::TriangleMesh {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return {};
  };
  EXPECT_THAT(said_of(sleep), HasSubstr("cannot read this mesh (it takes longer than 2.25 s)"));
  expect_no_children();
}

TEST(IsolatedMeshes, RefuseOneThatNeedsTooMuchMemory) {
  const auto devour = [](const std::string&) -> sim::TriangleMesh {
    std::vector<std::string> all;
    while (true) all.emplace_back(std::size_t{1} << 20U, 'x');
  };
  EXPECT_THAT(said_of(devour), HasSubstr("cannot read this mesh"));
  expect_no_children();
}

/// Files that crashed assimp or kept it busy before it was isolated.
class HardMesh : public testing::Test {
 protected:
  /// A file may be read or rejected, but in time and without a crash.
  void try_file(const std::string& name, const std::string& text) {
    const std::string path = (folder_.path() / name).string();
    std::ofstream(path, std::ios::binary) << text;
    const auto before = std::chrono::steady_clock::now();
    try {
      EXPECT_FALSE(read_isolated(path, sim::read_mesh_file, kShort).vertices.empty());
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(path + ": "));
    }
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(5)) << name;
    expect_no_children();
  }
  TemporaryFolder folder_;
};

TEST_F(HardMesh, PlyWithIndicesOutOfRange) {
  try_file("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
           "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 "
           "0 0\n0 1 0\n3 0 1 900000000\n");
}

TEST_F(HardMesh, PlyCutShort) {
  try_file("a.ply",
           "ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\nproperty float "
           "y\nproperty float z\nend_header\n0 0 0\n");
}

TEST_F(HardMesh, ColladaThatHoldsItself) {
  try_file("a.dae",
           "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
           "version=\"1.4.1\"><library_nodes><node id=\"a\"><instance_node url=\"#a\"/></node>"
           "</library_nodes><library_visual_scenes><visual_scene id=\"s\"><node id=\"n\">"
           "<instance_node url=\"#a\"/></node></visual_scene></library_visual_scenes><scene>"
           "<instance_visual_scene url=\"#s\"/></scene></COLLADA>");
}

TEST_F(HardMesh, ColladaNestedDeep) {
  std::string text =
      "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"><library_visual_scenes>"
      "<visual_scene id=\"s\">";
  for (int i = 0; i < 200000; ++i) text += "<node>";
  try_file("a.dae", text);
}

TEST_F(HardMesh, GltfNestedDeep) {
  try_file("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"x\":" + std::string(500000, '['));
}

TEST_F(HardMesh, ObjOfOneHugePolygon) {
  std::string text;
  std::string face = "f";
  for (int i = 1; i <= 100000; ++i) {
    text += "v " + std::to_string(i % 317) + " " + std::to_string(i % 211) + " 0\n";
    face += " " + std::to_string(i);
  }
  try_file("a.obj", text + face + "\n");
}

TEST_F(HardMesh, ObjOfManyGroups) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 100000; ++i) text += "g group" + std::to_string(i) + "\nf 1 2 3\n";
  try_file("a.obj", text);
}

TEST_F(HardMesh, ObjWhoseMaterialIsAPipe) {
  ASSERT_EQ(mkfifo((folder_.path() / "a.mtl").c_str(), 0600), 0);
  try_file("a.obj", "mtllib a.mtl\nusemtl x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
}

TEST_F(HardMesh, ThatIsAPipeIsRefused) {
  const std::string path = (folder_.path() / "pipe.stl").string();
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_THAT(said_of(sim::read_mesh_file, path),
              HasSubstr("pipe.stl: cannot read this mesh (it is not a"));
  EXPECT_THAT(said_of(sim::read_mesh_file, "/dev/zero"), HasSubstr("not a regular file"));
}

TEST_F(HardMesh, IsReportedByTheLoaderToo) {
  isolate_meshes(kShort);
  const std::string path = (folder_.path() / "nan.stl").string();
  std::ofstream(path) << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1e30 0 0\nvertex 1 0 0\n"
                         "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
  try {
    (void)sim::load_mesh(path, Eigen::Vector3d::Ones());
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("beyond 1000 km"));
  }
  sim::use_mesh_reader({});
}

}  // namespace
}  // namespace castaway::testbed
