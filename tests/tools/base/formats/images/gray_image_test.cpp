#include "tools/base/formats/images/gray_image.hpp"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>
#include <jpeglib.h>
#include <png.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Pixels = std::vector<std::uint16_t>;

/// A PNG in one of libpng's simple formats.
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
  EXPECT_TRUE(contains(error_of([] { decode_pgm("P4 1 1\na", "a"); }), "P2, P3, P5"));
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

TEST(PngGray, TellsWhatIsNotOpaque) {
  const std::uint8_t pixels[] = {0, 0, 0, 0, 9, 9, 9, 255, 255, 255, 255, 254};
  const GrayImage image = decode_png_gray(png_of(3, 1, PNG_FORMAT_RGBA, pixels), "a.png");
  EXPECT_EQ(image.pixels, (Pixels{0, 9, 255}));
  EXPECT_EQ(image.transparent, (std::vector<bool>{true, false, true}));
  const std::uint8_t opaque[] = {9, 9, 9, 255};
  EXPECT_TRUE(decode_png_gray(png_of(1, 1, PNG_FORMAT_RGBA, opaque), "a.png").transparent.empty());
}

TEST(Ppm, TakesTheMeanOfTheColours) {
  EXPECT_EQ(decode_pgm("P3 2 1 255\n10 20 60  255 255 255\n", "a").pixels, (Pixels{30, 255}));
  EXPECT_EQ(decode_pgm(std::string("P6 2 1 255\n") + "\x0a\x14\x3c" + "\xff\xff\xff", "a").pixels,
            (Pixels{30, 255}));
  EXPECT_TRUE(
      contains(error_of([] { decode_pgm("P6 1 1 255\nab", "a.ppm"); }), "a.ppm: cut short"));
}

/// A bitmap of two rows, the lower one first; with a palette of four greys if `bits` is at most 8.
std::string bmp_of(int bits, const std::string& rows, int height = 2) {
  const auto number = [](std::int64_t value, int size) {
    std::string text;
    for (int i = 0; i < size; ++i) text += static_cast<char>(i < 8 ? value >> (8 * i) & 255 : 0);
    return text;
  };
  const std::string palette =
      bits > 8 ? "" : std::string("\0\0\0\0\x64\x64\x64\0\xcd\xcd\xcd\0\xff\xff\xff\0", 16);
  const std::string info = number(40, 4) + number(2, 4) + number(height, 4) + number(1, 2) +
                           number(bits, 2) + number(0, 20) + number(4, 4) + number(0, 0);
  const auto offset = static_cast<std::int64_t>(14 + 40 + palette.size());
  std::string header = info.substr(0, 32) + number(bits > 8 ? 0 : 4, 4) + number(0, 4);
  return "BM" + number(0, 8) + number(offset, 4) + header + palette + rows;
}

TEST(Bmp, ReadsPalettesAndColours) {
  const std::string eight("\x01\x02\0\0\x03\0\0\0", 8);
  EXPECT_EQ(decode_bmp_gray(bmp_of(8, eight), "a").pixels, (Pixels{255, 0, 100, 205}));
  EXPECT_EQ(decode_bmp_gray(bmp_of(8, eight, -2), "a").pixels, (Pixels{100, 205, 255, 0}));
  const std::string four("\x12\0\0\0\x30\0\0\0", 8);
  EXPECT_EQ(decode_bmp_gray(bmp_of(4, four), "a").pixels, (Pixels{255, 0, 100, 205}));
  const std::string full("\x0a\x14\x3c\xff\xff\xff\0\0\0\0\0\0\0\0\0\0", 16);
  EXPECT_EQ(decode_bmp_gray(bmp_of(24, full), "a").pixels, (Pixels{0, 0, 30, 255}));
}

TEST(Bmp, RefusesWhatIsBroken) {
  const std::string eight("\x01\x02\0\0\x03\0\0\0", 8);
  const std::string bmp = bmp_of(8, eight);
  for (std::size_t size = 2; size < bmp.size(); ++size) {
    EXPECT_TRUE(contains(error_of([&] { decode_bmp_gray(bmp.substr(0, size), "a.bmp"); }),
                         "a.bmp: broken BMP"));
  }
  const std::string beyond("\x04\x02\0\0\x03\0\0\0", 8);
  EXPECT_TRUE(contains(error_of([&] { decode_bmp_gray(bmp_of(8, beyond), "a.bmp"); }), "palette"));
}

/// A JPEG of 8 x 8 pixels of one grey.
std::string jpeg_of(std::uint8_t gray) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = 8;
  jpeg.image_height = 8;
  jpeg.input_components = 1;
  jpeg.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<std::uint8_t> row(8, gray);
  JSAMPROW rows = row.data();
  for (int i = 0; i < 8; ++i) jpeg_write_scanlines(&jpeg, &rows, 1);
  jpeg_finish_compress(&jpeg);
  std::string text(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return text;
}

TEST(Jpeg, ReadsTheBrightness) {
  const GrayImage image = decode_jpeg_gray(jpeg_of(205), "a.jpg");
  EXPECT_EQ(image.width, 8);
  EXPECT_EQ(image.pixels, Pixels(64, 205));
}

TEST(Jpeg, RefusesWhatIsCutShort) {
  const std::string jpeg = jpeg_of(205);
  for (const std::size_t size : {std::size_t{3}, std::size_t{30}, jpeg.size() / 2}) {
    EXPECT_TRUE(contains(error_of([&] { decode_jpeg_gray(jpeg.substr(0, size), "a.jpg"); }),
                         "a.jpg: broken JPEG"));
  }
}

TEST(GrayImage, RefusesMorePixelsThanMemoryHolds) {
  EXPECT_TRUE(contains(error_of([] { decode_pgm("P5 16000 16000 255\n", "a.pgm"); }),
                       "a.pgm: 16000 x 16000 pixels"));
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
  EXPECT_EQ(load_gray_image(folder.put("a.bin", jpeg_of(205))).pixels.size(), 64U);
  EXPECT_EQ(load_gray_image(folder.put("a.png", "P5 1 1 255\nA")).pixels, (Pixels{'A'}));
  const auto other = folder.put("a.pgm", "GIF89a");
  EXPECT_TRUE(contains(error_of([&] { load_gray_image(other); }), "a.pgm: neither PNG"));
  EXPECT_TRUE(contains(error_of([&] { load_gray_image(folder.path() / "none.pgm"); }),
                       "none.pgm: cannot be read"));
}

}  // namespace
}  // namespace castaway::testbed
