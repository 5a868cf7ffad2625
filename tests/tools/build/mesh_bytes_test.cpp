#include "tools/build/mesh_bytes.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

const sim::TriangleMesh kMesh{{{0.1F, 2.0F, 3.0F}, {4.0F, 5.0F, 6.0F}},
                              {{0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}},
                              {{0.5F, 0.5F, 0.5F}, {0.1F, 0.2F, 0.3F}},
                              {0, 1, 1}};

TEST(MeshBytes, BringAMeshAcross) {
  const auto answer = mesh_answer(to_bytes(kMesh));
  ASSERT_TRUE(answer);
  const auto& mesh = std::get<sim::TriangleMesh>(*answer);
  EXPECT_EQ(mesh.vertices, kMesh.vertices);
  EXPECT_EQ(mesh.normals, kMesh.normals);
  EXPECT_EQ(mesh.colors, kMesh.colors);
  EXPECT_EQ(mesh.indices, kMesh.indices);
}

TEST(MeshBytes, BringAMeshOfNothingAcross) {
  const auto answer = mesh_answer(to_bytes(sim::TriangleMesh{}));
  ASSERT_TRUE(answer);
  EXPECT_TRUE(std::get<sim::TriangleMesh>(*answer).vertices.empty());
}

TEST(MeshBytes, BringAReasonAcross) {
  for (const bool too_large : {false, true}) {
    const auto answer = mesh_answer(to_bytes(MeshFailure{"why", too_large}));
    ASSERT_TRUE(answer);
    EXPECT_EQ(std::get<MeshFailure>(*answer).text, "why");
    EXPECT_EQ(std::get<MeshFailure>(*answer).too_large, too_large);
  }
}

TEST(MeshBytes, AreNoAnswerIfCutShortOrTooLong) {
  const std::string bytes = to_bytes(kMesh);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(mesh_answer(std::string_view(bytes).substr(0, length))) << length;
  }
  EXPECT_FALSE(mesh_answer(bytes + "x"));
  EXPECT_FALSE(mesh_answer("x"));
  EXPECT_FALSE(mesh_answer("m" + std::string(40, '\xff')));
}

}  // namespace
}  // namespace castaway::testbed
