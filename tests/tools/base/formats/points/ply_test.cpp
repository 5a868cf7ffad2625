#include "tools/base/formats/points/ply.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/base/formats/points/cloud_bytes.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Vertices = std::vector<Eigen::Vector3d>;

constexpr const char* kTextBegin = "ply\nformat ascii 1.0\n";
constexpr const char* kThreeFloats = "property float x\nproperty float y\nproperty float z\n";

/// Vertices between two other elements; lists and other properties are everywhere.
std::string rich_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment made by hand\nobj_info x\n"
         "element camera 2\nproperty list uchar short view\nproperty double f\n"
         "element empty 4000000000\n"
         "element vertex 2\nproperty uchar red\nproperty double z\n"
         "property list ushort int32 seen\nproperty int16 x\nproperty float32 y\n"
         "property list int8 float none\n"
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string rich_body(std::endian order) {
  const auto bytes = [order](auto value) { return bytes_of(value, order); };
  return "\x02" + bytes(std::int16_t{5}) + bytes(std::int16_t{6}) + bytes(0.5) +  // camera
         std::string(1, '\0') + bytes(0.25) +                                     // camera
         "r" + bytes(3.25) + bytes(std::uint16_t{1}) + bytes(std::int32_t{9}) +
         bytes(std::int16_t{-1}) + bytes(2.0F) + std::string(1, '\0') +  // vertex
         "r" + bytes(-6.5) + bytes(std::uint16_t{0}) + bytes(std::int16_t{4}) + bytes(5.0F) +
         "\x01" + bytes(8.0F) +  // vertex
         "\x03" + bytes(std::int32_t{0}) + bytes(std::int32_t{1}) + bytes(std::int32_t{0});
}

const Vertices& rich_vertices() {
  static const Vertices vertices{{-1.0, 2.0, 3.25}, {4.0, 5.0, -6.5}};
  return vertices;
}

constexpr const char* kRichText =
    "2 5 6 0.5\n0 0.25\n255 3.25 1 9 -1 2 0\n0 -6.5 0 4 5 1 8\n3 0 1 0\n";

std::string ply_error(const std::string& bytes) {
  return error_of([&] { (void)decode_ply(bytes, "maps/a.ply"); });
}

TEST(Ply, ReadsText) {
  EXPECT_EQ(decode_ply(std::string(kTextBegin) + "element vertex 2\n" + kThreeFloats +
                           "end_header\n1 -2.5 3e1\n\n 4\t5  6",
                       "a"),
            (Vertices{{1.0, -2.5, 30.0}, {4.0, 5.0, 6.0}}));
}

TEST(Ply, SkipsOtherPropertiesElementsAndListsOfText) {
  EXPECT_EQ(decode_ply(rich_header("ascii") + kRichText, "a"), rich_vertices());
}

TEST(Ply, SkipsOtherPropertiesElementsAndListsOfBinaryData) {
  EXPECT_EQ(decode_ply(rich_header("binary_little_endian") + rich_body(std::endian::little), "a"),
            rich_vertices());
  EXPECT_EQ(decode_ply(rich_header("binary_big_endian") + rich_body(std::endian::big), "a"),
            rich_vertices());
}

TEST(Ply, ReadsLinesThatEndInCrLf) {
  EXPECT_EQ(decode_ply("ply\r\nformat binary_little_endian 1.0\r\nelement vertex 1\r\n"
                       "property uchar x\r\nproperty uchar y\r\nproperty uchar z\r\nend_header\r\n"
                       "\n\r\n",
                       "a"),
            (Vertices{{'\n', '\r', '\n'}}));
  EXPECT_EQ(decode_ply("ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty uchar x\r\n"
                       "property uchar y\r\nproperty uchar z\r\nend_header\r\n1 2 3\r\n",
                       "a"),
            (Vertices{{1.0, 2.0, 3.0}}));
}

/// The vertex whose x, y and z are `value`, with properties of this type.
template <typename T>
Eigen::Vector3d vertex_of(const std::string& type, T value) {
  const std::string header = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty " +
                             type + " x\nproperty " + type + " y\nproperty " + type +
                             " z\nend_header\n";
  const std::string bytes = bytes_of(value, std::endian::big);
  return decode_ply(header + bytes + bytes + bytes, "a").at(0);
}

TEST(Ply, KnowsBothNamesOfAllTypes) {
  const auto all = [](double value) -> Eigen::Vector3d { return {value, value, value}; };
  for (const char* type : {"char", "int8"}) {
    EXPECT_EQ(vertex_of(type, std::int8_t{-1}), all(-1));
  }
  for (const char* type : {"uchar", "uint8"}) {
    EXPECT_EQ(vertex_of(type, std::uint8_t{255}), all(255));
  }
  for (const char* type : {"short", "int16"}) {
    EXPECT_EQ(vertex_of(type, std::int16_t{-300}), all(-300));
  }
  for (const char* type : {"ushort", "uint16"}) {
    EXPECT_EQ(vertex_of(type, std::uint16_t{65535}), all(65535));
  }
  for (const char* type : {"int", "int32"}) {
    EXPECT_EQ(vertex_of(type, std::int32_t{-70000}), all(-70000));
  }
  for (const char* type : {"uint", "uint32"}) {
    EXPECT_EQ(vertex_of(type, std::uint32_t{4000000000}), all(4e9));
  }
  for (const char* type : {"float", "float32"}) EXPECT_EQ(vertex_of(type, 1.5F), all(1.5));
  for (const char* type : {"double", "float64"}) EXPECT_EQ(vertex_of(type, 0.1), all(0.1));
}

TEST(Ply, MayHoldNoVertices) {
  const std::string header =
      std::string(kTextBegin) + "element vertex 0\n" + kThreeFloats + "end_header";
  EXPECT_TRUE(decode_ply(header, "a").empty());
}

TEST(Ply, KeepsTheVerticesThatAreNotFinite) {
  const Vertices vertices = decode_ply(
      std::string(kTextBegin) + "element vertex 1\n" + kThreeFloats + "end_header\nnan inf 0", "a");
  ASSERT_EQ(vertices.size(), 1U);
  EXPECT_TRUE(std::isnan(vertices[0].x()));
  EXPECT_TRUE(std::isinf(vertices[0].y()));
}

TEST(Ply, NamesTheLineOfTheHeaderThatIsMalformed) {
  EXPECT_TRUE(contains(ply_error("plyx\n"), "maps/a.ply:1: no PLY"));
  EXPECT_TRUE(contains(ply_error("ply\rformat ascii 1.0\r"), "a.ply:1: no PLY"));
  EXPECT_TRUE(contains(ply_error("ply\nformat binary 1.0\n"), "a.ply:2: format 'binary' '1.0'"));
  EXPECT_TRUE(contains(ply_error("ply\nformat ascii 2.0\n"), "a.ply:2: format 'ascii' '2.0'"));
  const std::string begin = kTextBegin;
  EXPECT_TRUE(contains(ply_error(begin + "elements vertex 1\n"), "a.ply:3: no entry"));
  EXPECT_TRUE(contains(ply_error(begin + "element vertex -1\n"), "a.ply:3: element 'vertex' has"));
  EXPECT_TRUE(contains(ply_error(begin + "property float x\n"), "a.ply:3: a property before"));
  const std::string vertex = begin + "element vertex 1\n";
  EXPECT_TRUE(contains(ply_error(vertex + "property real x\n"), "a.ply:4: no type of PLY: 'real'"));
  EXPECT_TRUE(contains(ply_error(vertex + "property list float int x\n"), "a.ply:4: the length"));
  EXPECT_TRUE(contains(ply_error(vertex), "a.ply: cut short after line 3"));
}

TEST(Ply, NamesWhatTheHeaderLacks) {
  const std::string begin = kTextBegin;
  EXPECT_TRUE(contains(ply_error(begin + "end_header\n"), "no element 'vertex'"));
  EXPECT_TRUE(contains(ply_error("ply\nelement vertex 0\nend_header\n"), "states no format"));
  EXPECT_TRUE(contains(ply_error(begin + "element vertex 1\nproperty float x\nproperty float y\n"
                                         "property list uchar float z\nend_header\n1 2 1 3\n"),
                       "a.ply: 0 fields are named 'z'"));
}

TEST(Ply, NamesTheVertexThatIsMalformed) {
  const std::string header =
      std::string(kTextBegin) + "element vertex 1\n" + kThreeFloats + "end_header\n";
  EXPECT_TRUE(contains(ply_error(header + "\n1 two 3\n"), "a.ply:9: 'y' is 'two'"));
  EXPECT_TRUE(contains(ply_error(header + "1 2  \n"), "a.ply:8: ends before its 'z'"));
  EXPECT_TRUE(contains(ply_error(header + "1 2 3 4\n"), "a.ply:8: more values"));
  EXPECT_TRUE(
      contains(ply_error(rich_header("ascii") + "-1 5 6 0.5\n"), "'view' is '-1'; write t"));
  EXPECT_TRUE(
      contains(ply_error(rich_header("ascii") + "4000000000 5\n"), "ends before its 'view'"));
}

TEST(Ply, RefusesMoreThanTheFileHolds) {
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    EXPECT_TRUE(contains(ply_error("ply\nformat " + format + " 1.0\nelement vertex 4000000000\n" +
                                   kThreeFloats + "end_header\n1 2 3\n"),
                         "a.ply: cut short: 4000000000 x"));
    EXPECT_TRUE(contains(ply_error("ply\nformat " + format +
                                   " 1.0\nelement other 4000000000\nproperty int a\n"
                                   "element vertex 1\n" +
                                   kThreeFloats + "end_header\n1\n"),
                         "a.ply: cut short"));
  }
}

TEST(Ply, RefusesListsOfNegativeLength) {
  EXPECT_TRUE(
      contains(ply_error(std::string("ply\nformat binary_big_endian 1.0\nelement vertex 1\n") +
                         "property list char int a\n" + kThreeFloats + "end_header\n\xff" +
                         std::string(12, '.')),
               "a.ply: a list 'a' has the length -1"));
}

TEST(Ply, SurvivesDamage) {
  expect_damage_is_survived(rich_header("ascii") + kRichText, decode_ply);
  expect_damage_is_survived(rich_header("binary_little_endian") + rich_body(std::endian::little),
                            decode_ply);
  expect_damage_is_survived(rich_header("binary_big_endian") + rich_body(std::endian::big),
                            decode_ply);
}

}  // namespace
}  // namespace castaway::testbed
