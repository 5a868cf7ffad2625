// Tests castaway report, and films.
#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

const std::string kReported = "run --duration 3 --set events=[] --set outputs.snapshots=false ";

TEST(Report, IsMadeAgainFromTheFolderAlone) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kReported + "--out run").exit_code, 0);
  const std::string page = text_of(folder / "run/report.html");
  EXPECT_GT(page.size(), 10000U);
  fs::remove(folder / "run/report.html");
  const Outcome outcome = castaway(folder, "report run");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "run/report.html\n");
  EXPECT_TRUE(text_of(folder / "run/report.html") == page);
}

TEST(Report, OfSeveralRunsLeadsToThem) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kReported + "--seed 1 --out one").exit_code, 0);
  ASSERT_EQ(castaway(folder, kReported + "--seed 2 --out two").exit_code, 0);
  const Outcome outcome = castaway(folder, "report one two --out pages/index.html");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = text_of(folder / "pages/index.html");
  expect_contains(page, "<a href=\"../one/report.html\">seed 1</a>");
  expect_contains(page, "<a href=\"../two/report.html\">seed 2</a>");
}

TEST(Report, OfManySeedsIsNamedOnTheTerminalAndTheSameInEveryRepetition) {
  const fs::path folder = fresh_folder();
  const std::string seeds = kReported + "--seeds 2 --out ";
  const Outcome outcome = castaway(folder, seeds + "a --expect \"distance_m > 1000\"");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  expect_contains(outcome.out, "Page:        a/index.html\n");
  const std::string page = text_of(folder / "a/index.html");
  expect_contains(page, "<h1>lab-kidnap: 2 runs</h1>");
  expect_contains(page, "Expectations: 0 of 2 met.");
  ASSERT_EQ(castaway(folder, seeds + "b -j 2 --expect \"distance_m > 1000\"").exit_code, 3);
  EXPECT_TRUE(text_of(folder / "b/index.html") == page);
  const Outcome without = castaway(folder, seeds + "c --set outputs.report=false");
  EXPECT_EQ(without.out.find("Page:"), std::string::npos);
}

TEST(Report, WithoutAPlayerHasNoRecording) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kReported + "--out run").exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "run/recording.gz"));
  ASSERT_EQ(castaway(folder, kReported + "--set outputs.player=false --out run").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "run/recording.gz"));
  expect_contains(text_of(folder / "run/report.html"), "This page has no player");
}

TEST(Report, NamesWhatIsNoRun) {
  const fs::path folder = fresh_folder();
  fs::create_directories(folder / "empty");
  const Outcome gone = castaway(folder, "report gone");
  EXPECT_EQ(gone.exit_code, 2);
  expect_contains(gone.err, "gone: no such folder");
  const Outcome empty = castaway(folder, "report empty");
  EXPECT_EQ(empty.exit_code, 2);
  expect_contains(empty.err, "empty: no run here");
}

TEST(Report, NamesADamagedRecording) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kReported + "--out run").exit_code, 0);
  std::ofstream(folder / "run/recording.gz") << "damaged";
  const Outcome outcome = castaway(folder, "report run");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "recording.gz: ");
}

TEST(Report, NamesADamagedSummary) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, kReported + "--out run").exit_code, 0);
  std::ofstream(folder / "run/summary.json") << R"({"seed": "x", "scenario": 7, "localizers": {}})";
  expect_refused(castaway(folder, "report run"), {"run/summary.json: damaged"});
  expect_refused(castaway(folder, "compare run run"), {"run/summary.json: damaged"});
}

TEST(Film, IsMadeOfARun) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is missing";
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(
      folder, kReported +
                  "--video film.webm --set 'outputs.video={width: 160, height: 90, fps: 5}' "
                  "--out run");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "Film:       film.webm");
  EXPECT_GT(fs::file_size(folder / "film.webm"), 1000U);
}

TEST(Film, SaysWhatIsMissingBeforeTheRun) {
  const fs::path folder = fresh_folder();
  const Outcome kind = castaway(folder, kReported + "--video film.avi --out run");
  EXPECT_EQ(kind.exit_code, 2);
  expect_contains(kind.err, "film.avi: a film's name must end in .mp4 or .webm");
  const Outcome missing =
      castaway(folder, kReported + "--video film.mp4 --out run", "PATH=/nowhere");
  EXPECT_EQ(missing.exit_code, 2);
  expect_contains(missing.err, "apt-get install ffmpeg");
  EXPECT_FALSE(fs::exists(folder / "run"));
  EXPECT_FALSE(fs::exists(folder / "film.mp4"));
}

// A shell expands DIR/* to the run folders and the files beside them.
TEST(ReportCommand, TakesAllThatManySeedsLeft) {
  const fs::path folder = fresh_folder();
  ASSERT_EQ(castaway(folder, "run --duration 2 --set outputs.snapshots=false --seeds 2 --out all")
                .exit_code,
            0);
  const Outcome star = castaway(folder, "report all/* --out index.html");
  EXPECT_EQ(star.exit_code, 0) << star.err;
  expect_contains(text_of(folder / "index.html"), "all/seed-2/report.html");
  const Outcome whole = castaway(folder, "report all --out whole.html");
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  expect_contains(text_of(folder / "whole.html"), "all/seed-1/report.html");
  EXPECT_EQ(castaway(folder, "report all/summary.json").exit_code, 2);
}

}  // namespace
}  // namespace castaway::test
