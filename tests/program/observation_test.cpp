// The picture of a scan on the map.
#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

/// Big-endian number of four bytes.
int number_at(const std::string& bytes, std::size_t at) {
  int number = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    number = 256 * number + static_cast<unsigned char>(bytes[i]);
  return number;
}

TEST(ObservationPicture, HasAPanelForEachScenario) {
  const fs::path folder = fresh_folder();
  const std::string size = " --width 320 --height 200";
  const Outcome outcome = castaway(folder, "observation lab hillside" + size);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "lab: 90 beams on a planar map, mean likelihood 0.");
  expect_contains(outcome.out, " beams on a 3-D map, mean likelihood 0.9");
  expect_contains(outcome.out, "observation.png\n");
  const std::string png = text_of(folder / "observation.png");
  expect_contains(png.substr(0, 8), "PNG");
  EXPECT_EQ(number_at(png, 16), 320);
  EXPECT_EQ(number_at(png, 20), 200 + 12 + 200);
  // Its own file is replaced, by the same bytes.
  EXPECT_EQ(castaway(folder, "observation lab hillside" + size).exit_code, 0);
  EXPECT_EQ(text_of(folder / "observation.png"), png);
}

TEST(ObservationPicture, BadInputIsNamed) {
  const fs::path folder = fresh_folder();
  expect_refused(castaway(folder, "observation lab/kidnp"), {"lab/kidnp", "lab/kidnap"});
  expect_refused(castaway(folder, "observation labb"), {"labb"});
  expect_refused(castaway(folder, "observation lab --out figure.jpg"), {"--out", "figure.jpg"});
  expect_refused(castaway(folder, "observation lab --reach 0"), {"--reach"});
  expect_refused(castaway(folder, "observation lab --robot none"), {"robot 'none' not found"});
  expect_refused(castaway(folder, "observation lab/lidar-3d --time 60"), {"60 s", "20 s"});
  EXPECT_FALSE(fs::exists(folder / "observation.png"));
}

TEST(ObservationPicture, AFileThatCastawayDidNotWriteIsKept) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "figure.png") << "mine";
  expect_refused(castaway(folder, "observation lab --out figure.png"), {"figure.png: exists"});
  EXPECT_EQ(text_of(folder / "figure.png"), "mine");
}

}  // namespace
}  // namespace castaway::test
