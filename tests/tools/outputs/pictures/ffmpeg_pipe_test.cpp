#include "tools/outputs/pictures/ffmpeg_pipe.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/ffmpeg.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

sim::Image gray(std::uint8_t level) {
  return {64, 48, std::vector<std::uint8_t>(std::size_t{3} * 64 * 48, level)};
}

FilmFormat format(const std::filesystem::path& file) { return {file, 64, 48, 10}; }

TEST(FilmFormat, RefusesWhatNoFilmCanBe) {
  const auto error = [](const FilmFormat& bad) { return error_of([&] { validate(bad); }); };
  EXPECT_TRUE(contains(error(format("film.avi")), "film.avi: a film's name must end in .mp4"));
  EXPECT_TRUE(contains(error({"film.mp4", 63, 48, 10}), "63 px"));
  EXPECT_TRUE(contains(error({"film.mp4", 64, 4098, 10}), "4098 px"));
  EXPECT_TRUE(contains(error({"film.mp4", 64, 48, 0}), "0 pictures a second"));
  EXPECT_NO_THROW(validate(format("film.webm")));
}

TEST(FfmpegPipe, WritesAFilmOfEitherKind) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  for (const char* name : {"new/film.mp4", "film.webm"}) {
    const std::filesystem::path file = folder.path() / name;
    FfmpegPipe pipe(format(file));
    for (int i = 0; i < 12; ++i) pipe.add(gray(static_cast<std::uint8_t>(20 * i)));
    EXPECT_FALSE(std::filesystem::exists(file));
    pipe.commit();
    const std::string bytes = read_file(file);
    EXPECT_TRUE(contains(bytes.substr(0, 64), name[0] == 'n' ? "ftyp" : "webm")) << name;
    EXPECT_FALSE(std::filesystem::exists(file.parent_path() /
                                         (".castaway-unfinished-" + file.filename().string())));
  }
}

TEST(FfmpegPipe, LeavesNothingOfAFilmThatWasNotFinished) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  {
    FfmpegPipe pipe(format(folder.path() / "film.mp4"));
    pipe.add(gray(1));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FfmpegPipe, SaysWhatFfmpegSaysWhenItGivesUp) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / ".castaway-unfinished-film.mp4/in the way");
  const auto film = [&] {
    FfmpegPipe pipe(format(folder.path() / "film.mp4"));
    for (int i = 0; i < 1000; ++i) pipe.add(gray(1));
    pipe.commit();
  };
  EXPECT_TRUE(contains(error_of(film), "film.mp4: ffmpeg could not write the film: "));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "film.mp4"));
}

TEST(FfmpegPipe, SaysWhatToInstall) {
  const TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path().c_str(), 1);
  const std::string error =
      error_of([&] { const FfmpegPipe pipe(format(folder.path() / "a.mp4")); });
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(contains(error, "apt-get install ffmpeg"));
}

TEST(FfmpegPipe, TakesPicturesOfOneSizeOnly) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const TemporaryFolder folder;
  FfmpegPipe pipe(format(folder.path() / "film.mp4"));
  EXPECT_TRUE(contains(error_of([&] {
                         pipe.add({2, 2, std::vector<std::uint8_t>(12)});
                       }),
                       "another size"));
}

}  // namespace
}  // namespace castaway::testbed
