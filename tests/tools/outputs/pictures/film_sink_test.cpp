#include "tools/outputs/pictures/film_sink.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/ffmpeg.hpp"
#include "tests/tools/support/records.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

const std::vector<std::string> kFilmed{"a"};

RosMap filmed_map() {
  RosMap map;
  map.width = 20;
  map.height = 10;
  map.resolution = 0.1;
  map.cells.assign(200, 0);
  return map;
}

FilmConfig config(const std::filesystem::path& file) {
  FilmConfig config;
  config.format = {file, 64, 48, 10};
  return config;
}

OdometryFrame filmed_odometry(double t) {
  return {{localization::from_seconds(t), {0.1 * t, 0.0, 0.0}}, SE2{0.1 * t, 0.0, 0.0}};
}

/// File size of a film of two seconds of a run; 0 if there is none.
std::uintmax_t film_of(const FilmConfig& config, bool with_truth = true) {
  PictureWorld world;
  world.map = filmed_map();
  FilmSink sink(config, world);
  for (int i = 0; i < 40; ++i) {
    if (i % 4 == 0) sink.on_scan(record_at(0.05 * i, kFilmed));
    OdometryFrame frame = filmed_odometry(0.05 * i);
    if (!with_truth) frame.true_pose.reset();
    sink.on_odometry(frame);
  }
  sink.finish(localization::from_seconds(2.0), {});
  const bool there = std::filesystem::exists(config.format.file);
  return there ? std::filesystem::file_size(config.format.file) : 0;
}

/// Number of frames in a film, counted by ffprobe.
int pictures_in(const std::filesystem::path& file) {
  const std::string out = file.string() + ".txt";
  const std::string command =
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
      "stream=nb_read_frames -of csv=p=0 '" +
      file.string() + "' > '" + out + "'";
  if (std::system(command.c_str()) != 0) return -1;
  int count = -1;
  std::ifstream(out) >> count;
  return count;
}

TEST(FilmSink, RefusesOtherSpeeds) {
  FilmConfig bad = config("film.mp4");
  bad.speed = 0.0;
  EXPECT_TRUE(contains(error_of([&] { validate(bad); }), "must be above 0"));
}

TEST(FilmSink, FilmsEveryView) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  for (const FilmView view : {FilmView::kChase, FilmView::kOverview, FilmView::kMap}) {
    FilmConfig film = config(folder.path() / "film.mp4");
    film.view = view;
    EXPECT_GT(film_of(film), 0U) << static_cast<int>(view);
    EXPECT_EQ(pictures_in(film.format.file), 20) << static_cast<int>(view);
  }
}

TEST(FilmSink, ShowsARunFaster) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  FilmConfig film = config(folder.path() / "film.mp4");
  film.speed = 4.0;
  EXPECT_GT(film_of(film), 0U);
  EXPECT_EQ(pictures_in(film.format.file), 5);
}

TEST(FilmSink, LeavesNoFilmWithoutTruth) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  EXPECT_EQ(film_of(config(folder.path() / "film.mp4"), false), 0U);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(PutIntoCorner, SetsTheInsetWithinABorder) {
  sim::Image image{60, 40, std::vector<std::uint8_t>(std::size_t{3} * 60 * 40, 0)};
  const sim::Image inset{10, 5, std::vector<std::uint8_t>(std::size_t{3} * 10 * 5, 200)};
  put_into_corner(inset, image);
  const auto at = [&](int x, int y) {
    return image.pixels[static_cast<std::size_t>(3 * (y * 60 + x))];
  };
  EXPECT_EQ(at(38, 12), 200);  // 12 px from the right and from above
  EXPECT_EQ(at(47, 16), 200);
  EXPECT_EQ(at(37, 12), 40);
  EXPECT_EQ(at(48, 17), 40);
  EXPECT_EQ(at(35, 12), 0);
  EXPECT_EQ(at(50, 12), 0);
}

}  // namespace
}  // namespace castaway::testbed
