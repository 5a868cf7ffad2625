#include "tools/base/formats/points/pcd.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/base/formats/points/cloud_bytes.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Cloud = std::vector<Eigen::Vector3d>;

/// A header of three floats x, y, z.
std::string xyz_header(int points, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
         "TYPE F F F\nCOUNT 1 1 1\nWIDTH " +
         std::to_string(points) + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::to_string(points) + "\nDATA " + data + "\n";
}

/// The header of `mixed_point`.
std::string mixed_header(int points, const std::string& data) {
  return "VERSION .7\nFIELDS z _ rgb y histogram x\nSIZE 8 1 4 2 4 1\nTYPE F U U I F U\n"
         "COUNT 1 3 1 1 2 1\nWIDTH 1\nHEIGHT " +
         std::to_string(points) + "\nPOINTS " + std::to_string(points) + "\nDATA " + data + "\n";
}

std::string mixed_point(double z, std::int16_t y, std::uint8_t x) {
  return bytes_of(z) + "___" + bytes_of(0xff00ffU) + bytes_of(y) + bytes_of(9.0F) + bytes_of(NAN) +
         bytes_of(x);
}

/// The body of binary_compressed data.
std::string packed_body(const std::string& packed, std::size_t size) {
  return bytes_of(static_cast<std::uint32_t>(packed.size())) +
         bytes_of(static_cast<std::uint32_t>(size)) + packed;
}

std::string pcd_error(const std::string& bytes) {
  return error_of([&] { (void)decode_pcd(bytes, "maps/a.pcd"); });
}

TEST(Pcd, ReadsText) {
  EXPECT_EQ(decode_pcd(xyz_header(2, "ascii") + "1 -2.5 3e1\r\n\n\t4 5  6", "a"),
            (Cloud{{1.0, -2.5, 30.0}, {4.0, 5.0, 6.0}}));
}

TEST(Pcd, ReadsBinary) {
  const std::string body = bytes_of(1.0F) + bytes_of(-2.5F) + bytes_of(3.0F) + bytes_of(4.0F) +
                           bytes_of(5.0F) + bytes_of(6.0F);
  EXPECT_EQ(decode_pcd(xyz_header(2, "binary") + body + "trailing", "a"),
            (Cloud{{1.0, -2.5, 3.0}, {4.0, 5.0, 6.0}}));
}

TEST(Pcd, ReadsFieldsInAnyOrder) {
  const Cloud cloud{{200.0, -300.0, 0.1}, {7.0, 8.0, -9.0}};
  EXPECT_EQ(
      decode_pcd(mixed_header(2, "binary") + mixed_point(0.1, -300, 200) + mixed_point(-9.0, 8, 7),
                 "a"),
      cloud);
  EXPECT_EQ(
      decode_pcd(mixed_header(2, "ascii") + "0.1 0 0 0 4e9 -300 1 2 200\n-9 0 0 0 0 8 nan nan 7\n",
                 "a"),
      cloud);
}

TEST(Pcd, ReadsCompressedData) {
  // Four points with x = 1.5 (an overlapping repetition), y = 1, 2, 3, 4 and z = y (a far one).
  const std::string y = bytes_of(1.0F) + bytes_of(2.0F) + bytes_of(3.0F) + bytes_of(4.0F);
  const std::string packed =
      lzf_literals(bytes_of(1.5F)) + lzf_match(12, 4) + lzf_literals(y) + lzf_match(16, 16);
  const Cloud cloud{{1.5, 1.0, 1.0}, {1.5, 2.0, 2.0}, {1.5, 3.0, 3.0}, {1.5, 4.0, 4.0}};
  EXPECT_EQ(decode_pcd(xyz_header(4, "binary_compressed") + packed_body(packed, 48), "a"), cloud);
}

TEST(Pcd, ReadsCompressedDataWithAndWithoutPadding) {
  const Cloud cloud{{200.0, -300.0, 0.1}, {7.0, 8.0, -9.0}};
  const std::string z = bytes_of(0.1) + bytes_of(-9.0);
  const std::string rest = std::string(8, 'c') + bytes_of(std::int16_t{-300}) +
                           bytes_of(std::int16_t{8}) + std::string(16, 'h') + "\xc8\x07";
  for (const std::string padding : {"", "______"}) {
    const std::string data = z + padding + rest;
    EXPECT_EQ(decode_pcd(mixed_header(2, "binary_compressed") +
                             packed_body(lzf_literals(data), data.size()),
                         "a"),
              cloud)
        << padding;
  }
}

TEST(Pcd, KeepsThePointsThatAreNotFinite) {
  const Cloud cloud = decode_pcd(xyz_header(2, "ascii") + "nan nan nan\n1 inf 2\n", "a");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_TRUE(std::isnan(cloud[0].x()));
  EXPECT_TRUE(std::isinf(cloud[1].y()));
}

TEST(Pcd, ReadsOlderHeaders) {
  EXPECT_EQ(decode_pcd("# comment\n\nVERSION .5\r\nCOLUMNS x y z\r\nPOINTS 1\r\n# again\r\n"
                       "DATA ascii\r\n1 2 3\r\n",
                       "a"),
            (Cloud{{1.0, 2.0, 3.0}}));
  EXPECT_EQ(decode_pcd("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nDATA ascii\n1 2 3", "a"),
            (Cloud{{1.0, 2.0, 3.0}}));
}

TEST(Pcd, IgnoresTheViewpoint) {
  EXPECT_EQ(
      decode_pcd("FIELDS x y z\nVIEWPOINT 10 20 30 0 1 0 0\nPOINTS 1\nDATA ascii\n1 2 3", "a"),
      (Cloud{{1.0, 2.0, 3.0}}));
}

TEST(Pcd, MayHoldNoPoints) {
  for (const char* data : {"ascii", "binary", "binary_compressed"}) {
    EXPECT_TRUE(decode_pcd(xyz_header(0, data), "a").empty()) << data;
  }
}

TEST(Pcd, NamesTheLineThatIsMalformed) {
  EXPECT_TRUE(contains(pcd_error("FIELDS x y z\nPOINST 3\n"), "maps/a.pcd:2: no entry"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x\nFIELDS y\n"), "a.pcd:2: FIELDS"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x y\nSIZE 4 3\n"), "a.pcd:2: SIZE of field 'y' is '3'"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x y\nSIZE 4\n"), "a.pcd:2: SIZE of field 'y' is ''"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x y\nTYPE F F F\n"), "a.pcd:2: more values than the 2"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x y\nTYPE F D\n"), "a.pcd:2: TYPE of field 'y' is 'D'"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x\nCOUNT -1\n"), "a.pcd:2: COUNT of field 'x' is '-1'"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x\nCOUNT 4000000000\n"), "a.pcd:2: COUNT"));
  EXPECT_TRUE(contains(pcd_error("POINTS many\n"), "a.pcd:1: POINTS is 'many'"));
  EXPECT_TRUE(contains(pcd_error("DATA text\n"), "a.pcd:1: DATA is 'text'; write ascii"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x y z\n"), "a.pcd: cut short after line 1"));
}

TEST(Pcd, NamesTheFieldThatIsWrong) {
  const std::string end = "\nPOINTS 1\nDATA ascii\n1 2 3\n";
  EXPECT_TRUE(contains(pcd_error("FIELDS x y" + end), "0 fields are named 'z'"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x y z y" + end), "2 fields are named 'y'"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x y z\nCOUNT 1 2 1" + end), "field 'y' has SIZE 4 and"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x y z\nSIZE 2 4 4" + end), "field 'x' has SIZE 2"));
  EXPECT_TRUE(
      contains(pcd_error("FIELDS x y z\nDATA ascii\n"), "a.pcd: its header states no POIN"));
  EXPECT_TRUE(contains(pcd_error("FIELDS x y z\nWIDTH 2\nHEIGHT 3" + end), "WIDTH x HEIGHT is 6"));
}

TEST(Pcd, NamesThePointThatIsMalformed) {
  const std::string header = xyz_header(2, "ascii");
  EXPECT_TRUE(contains(pcd_error(header + "1 2 3\n\n4 five 6\n"), "a.pcd:14: y is 'five'"));
  EXPECT_TRUE(contains(pcd_error(header + "1 2 3\n4 5\n6"), "a.pcd:13: fewer values"));
  EXPECT_TRUE(contains(pcd_error(header + "1 2 3 4\n4 5 6\n"), "a.pcd:12: more values"));
  EXPECT_TRUE(contains(pcd_error(header + "1.0 2.0 3.0\n"), "a.pcd: cut short after line 12"));
}

TEST(Pcd, RefusesMoreThanTheFileHolds) {
  for (const std::string data : {"ascii", "binary"}) {
    EXPECT_TRUE(contains(
        pcd_error("FIELDS x y z\nWIDTH 4000000000\nHEIGHT 4000000000\nDATA " + data + "\n1 2 3\n"),
        "a.pcd: cut short: 16000000000000000000 x"));
  }
  EXPECT_TRUE(contains(pcd_error(xyz_header(1, "binary") + "12345678901"),
                       "a.pcd: cut short: 1 x 12 bytes are announced, 11 remain"));
}

TEST(Pcd, RefusesDamagedCompressedData) {
  const std::string header = xyz_header(1, "binary_compressed");
  const std::string packed = lzf_literals("123456789012");
  EXPECT_TRUE(contains(pcd_error(header + packed_body(packed, 13)), "13 bytes are compressed"));
  EXPECT_TRUE(contains(pcd_error(header + packed_body(packed + packed, 12)), "damaged"));
  EXPECT_TRUE(contains(pcd_error(header + packed_body("", 12)), "damaged"));
  EXPECT_TRUE(contains(pcd_error(header + packed_body(packed, 12).substr(0, 20)), "cut short"));
  EXPECT_TRUE(contains(pcd_error(header + "1234567"), "cut short"));
  const std::string huge = "FIELDS x y z\nPOINTS 357913941\nDATA binary_compressed\n";
  EXPECT_TRUE(contains(pcd_error(huge + packed_body(packed, 4294967292)), "damaged"));
}

TEST(Pcd, SurvivesDamage) {
  const std::string point = mixed_point(0.1, -300, 200);
  const std::string floats = lzf_literals(bytes_of(1.5F)) + lzf_match(44, 4);
  expect_damage_is_survived(mixed_header(2, "ascii") + "1 0 0 0 4 5 1 2 3\n1 0 0 0 4 5 1 2 3\n",
                            decode_pcd);
  expect_damage_is_survived(mixed_header(2, "binary") + point + point, decode_pcd);
  expect_damage_is_survived(xyz_header(4, "binary_compressed") + packed_body(floats, 48),
                            decode_pcd);
}

}  // namespace
}  // namespace castaway::testbed
