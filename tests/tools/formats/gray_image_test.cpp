#include "tools/formats/gray_image.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Pixels = std::vector<std::uint16_t>;

/// The bytes of a PNG in one of libpng's simple formats.
std::string png_of(int width, int height, png_uint_32 format, const void* pixels) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.format = format;
  header.width = static_cast<png_uint_32>(width);
  header.height = static_cast<png_uint_32>(height);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string png(size, '\0');
  EXPECT_NE(png_image_write_to_memory(&header, png.data(), &size, 0, pixels, 0, nullptr), 0);
  png.resize(size);
  return png;
}

TEST(Pgm, ReadsTextWithCommentsAnywhere) {
  const GrayImage image = decode_pgm(
      "P2 # grey\n# a comment\n3 # wide\n2\n#x\n9\n0 1 2\n# between rows\n7 8 9", "a.pgm");
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.max_value, 9);
  EXPECT_EQ(image.pixels, (Pixels{0, 1, 2, 7, 8, 9}));
}

TEST(Pgm, ReadsBinaryAfterExactlyOneBlank) {
  const GrayImage image = decode_pgm(std::string("P5\n2 1\n255\n\n\xff", 13), "a.pgm");
  EXPECT_EQ(image.pixels, (Pixels{'\n', 255}));
}

TEST(Pgm, ReadsSixteenBitsWithTheHighByteFirst) {
  const GrayImage image = decode_pgm(std::string("P5 2 1 65535\n\x01\x02\xff\xff", 17), "a.pgm");
  EXPECT_EQ(image.max_value, 65535);
  EXPECT_EQ(image.pixels, (Pixels{0x0102, 0xffff}));
}

TEST(Pgm, SurvivesWriting) {
  const GrayImage image{2, 2, 255, {0, 205, 254, 10}};
  const GrayImage again = decode_pgm(encode_pgm(image), "a.pgm");
  EXPECT_EQ(again.pixels, image.pixels);
  EXPECT_EQ(again.width, 2);
}

TEST(Pgm, NamesTheFileThatIsCutShort) {
  for (const std::string text :
       {"P5\n4 4\n255\nabc", "P2 4 4 255 1 2 3", "P5\n4", "P5", "P5 1 1 255"}) {
    EXPECT_TRUE(
        contains(error_of([&] { decode_pgm(text, "maps/a.pgm"); }), "maps/a.pgm: cut short"))
        << text;
  }
}

TEST(Pgm, RefusesWhatIsNoGreyPicture) {
  EXPECT_TRUE(contains(error_of([] { decode_pgm("P6 1 1 255\nabc", "a"); }), "P2 or P5"));
  EXPECT_TRUE(contains(error_of([] { decode_pgm("P5 0 1 255\n", "a"); }), "width"));
  EXPECT_TRUE(contains(error_of([] { decode_pgm("P5 99999999 99999999 255\n", "a"); }), "width"));
  EXPECT_TRUE(contains(error_of([] { decode_pgm("P5 1 1 70000\na", "a"); }), "largest value"));
  EXPECT_TRUE(contains(error_of([] { decode_pgm("P2 1 1 9 10", "a"); }), "pixel"));
}

TEST(PngGray, ReadsEightBits) {
  const std::uint8_t pixels[] = {0, 205, 254, 255};
  const GrayImage image = decode_png_gray(png_of(2, 2, PNG_FORMAT_GRAY, pixels), "a.png");
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.max_value, 255);
  EXPECT_EQ(image.pixels, (Pixels{0, 205, 254, 255}));
}

TEST(PngGray, ReadsSixteenBits) {
  const std::uint16_t pixels[] = {0, 0x1234, 0xffff};
  const GrayImage image = decode_png_gray(png_of(3, 1, PNG_FORMAT_LINEAR_Y, pixels), "a.png");
  EXPECT_EQ(image.max_value, 65535);
  EXPECT_EQ(image.pixels, (Pixels{0, 0x1234, 0xffff}));
}

TEST(PngGray, TakesTheMeanOfTheColours) {
  const std::uint8_t pixels[] = {10, 20, 60};
  EXPECT_EQ(decode_png_gray(png_of(1, 1, PNG_FORMAT_RGB, pixels), "a.png").pixels, (Pixels{30}));
}

TEST(PngGray, MixesTransparencyWithWhite) {
  const std::uint8_t pixels[] = {0, 0, 0, 0, 0, 0, 0, 255};
  EXPECT_EQ(decode_png_gray(png_of(2, 1, PNG_FORMAT_RGBA, pixels), "a.png").pixels,
            (Pixels{255, 0}));
}

TEST(PngGray, NamesTheFileThatIsCutShort) {
  const std::uint8_t pixels[] = {0, 205, 254, 255};
  const std::string png = png_of(2, 2, PNG_FORMAT_GRAY, pixels);
  for (const std::size_t size :
       {std::size_t{9}, std::size_t{30}, png.size() / 2, png.size() - 20}) {
    EXPECT_TRUE(contains(error_of([&] { decode_png_gray(png.substr(0, size), "maps/a.png"); }),
                         "maps/a.png: broken PNG"));
  }
}

TEST(GrayImage, IsToldApartByItsFirstBytes) {
  const TemporaryFolder folder;
  EXPECT_EQ(load_gray_image(folder.put("a.png", "P5 1 1 255\nA")).pixels, (Pixels{'A'}));
  const auto other = folder.put("a.pgm", "GIF89a");
  EXPECT_TRUE(contains(error_of([&] { load_gray_image(other); }), "a.pgm: neither PGM"));
  EXPECT_TRUE(contains(error_of([&] { load_gray_image(folder.path() / "none.pgm"); }),
                       "none.pgm: cannot be read"));
}

}  // namespace
}  // namespace castaway::testbed
