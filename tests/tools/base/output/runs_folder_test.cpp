#include "tools/base/output/runs_folder.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/output/default_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

OutputRequest runs_request(const fs::path& target) { return {target, "run --seeds", "all"}; }

std::vector<PlannedRun> seeds(int count, const std::string& settings = "s") {
  std::vector<PlannedRun> runs;
  for (int i = 1; i <= count; ++i) {
    runs.push_back({"seed-" + std::to_string(i), settings + std::to_string(i)});
  }
  return runs;
}

void write_run_of_many(const fs::path& folder, const PlannedRun& run) {
  OutputFolder output({folder / run.folder, "run", run.settings});
  write_file(output.folder() / "errors.csv", "e");
  output.commit();
}

TEST(RunsFolder, GoesOnWhereItWasStopped) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "all";
  {
    const RunsFolder folder(runs_request(path), seeds(3));
    EXPECT_FALSE(folder.has_run(0));
    write_run_of_many(path, seeds(3)[0]);
  }
  const RunsFolder again(runs_request(path), seeds(3));
  EXPECT_TRUE(again.has_run(0));
  EXPECT_FALSE(again.has_run(1));
}

TEST(RunsFolder, MakesEverythingAgainOnceItIsFinished) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "all";
  {
    RunsFolder folder(runs_request(path), seeds(1));
    write_run_of_many(path, seeds(1)[0]);
    folder.finish();
  }
  EXPECT_FALSE(RunsFolder(runs_request(path), seeds(1)).has_run(0));
}

TEST(RunsFolder, DoesNotGoOnWithOtherSettings) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "all";
  {
    const RunsFolder folder(runs_request(path), seeds(1));
    write_run_of_many(path, seeds(1)[0]);
  }
  OutputRequest other = runs_request(path);
  other.settings = "other";
  EXPECT_FALSE(RunsFolder(other, seeds(1)).has_run(0));
}

TEST(RunsFolder, DoesNotGoOnWithAnotherProgram) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "all";
  {
    const RunsFolder folder(runs_request(path), seeds(1));
    write_run_of_many(path, seeds(1)[0]);
  }
  FileRecord record = load_record(path).value();
  EXPECT_EQ(record.program, program_hash());
  record.program = "older";
  save_record(path, record);
  EXPECT_FALSE(RunsFolder(runs_request(path), seeds(1)).has_run(0));
}

TEST(RunsFolder, RemovesRunsAndFilesOfAnEarlierCall) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "all";
  {
    RunsFolder folder(runs_request(path), seeds(3));
    for (const PlannedRun& run : seeds(3)) write_run_of_many(path, run);
    folder.put("summary.json", "three");
    folder.put("runs.csv", "three");
    folder.finish();
  }
  temporary.put("all/seed-3/mine.txt", "mine");
  {
    OutputRequest request = runs_request(path);
    RunsFolder folder(request, seeds(1));
    folder.put("summary.json", "one");
    folder.finish();
  }
  EXPECT_EQ(read_file(path / "summary.json"), "one");
  EXPECT_FALSE(fs::exists(path / "runs.csv"));
  EXPECT_TRUE(fs::exists(path / "seed-1/errors.csv"));
  EXPECT_FALSE(fs::exists(path / "seed-2"));
  EXPECT_EQ(read_file(path / "seed-3/mine.txt"), "mine");
  EXPECT_FALSE(fs::exists(path / "seed-3/errors.csv"));
}

TEST(RunsFolder, RefusesFilesOfOthersInItAndInItsRuns) {
  const TemporaryFolder temporary;
  temporary.put("one/mine.txt", "mine");
  temporary.put("two/seed-2/mine.txt", "mine");
  for (const char* name : {"one", "two"}) {
    EXPECT_TRUE(
        contains(error_of([&] { RunsFolder(runs_request(temporary.path() / name), seeds(2)); }),
                 "mine.txt"));
  }
}

/// A repository that ships a folder `runs` must not reach the user's runs.
TEST(RunsFolder, RemovesNoRunOutsideItsFolder) {
  const TemporaryFolder temporary;
  write_run_of_many(temporary.path(), {"good", "s"});
  const fs::path all = temporary.path() / "all";
  fs::create_directories(all);
  fs::create_directory_symlink("../good", all / "link");
  for (const std::string& run : {std::string("../good"), (temporary.path() / "good").string()}) {
    temporary.put("all/" + std::string(kRecordName),
                  R"({"castaway": "1", "runs": [")" + run + R"("]})");
    EXPECT_TRUE(
        contains(error_of([&] { RunsFolder(runs_request(all), seeds(1)); }), "lists the path"));
  }
  FileRecord record;
  record.runs = {"link"};
  save_record(all, record);
  OutputRequest forced = runs_request(all);
  forced.force = true;
  RunsFolder(forced, seeds(1)).finish();
  EXPECT_TRUE(fs::exists(temporary.path() / "good/errors.csv"));
}

TEST(RunsFolder, WritesNoRunThroughALink) {
  const TemporaryFolder temporary;
  fs::create_directories(temporary.path() / "elsewhere");
  fs::create_directories(temporary.path() / "all");
  fs::create_directory_symlink("../elsewhere", temporary.path() / "all/seed-1");
  OutputRequest request = runs_request(temporary.path() / "all");
  request.force = true;
  EXPECT_TRUE(contains(error_of([&] { RunsFolder(request, seeds(1)); }), "seed-1: is a link"));
}

TEST(RunsFolder, KnowsAFileThatAKilledCallHadMoved) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "all";
  temporary.put("all/summary.json", "one");
  FileRecord record{"run --seeds", "all", false, {}, {}};
  record.coming["summary.json"] = hash_file(path, "summary.json");
  save_record(path, record);
  RunsFolder folder(runs_request(path), seeds(1));
  folder.put("summary.json", "two");
  folder.finish();
  EXPECT_EQ(read_file(path / "summary.json"), "two");
  EXPECT_FALSE(fs::exists(path / kStagingName));
  EXPECT_TRUE(load_record(path).value().coming.empty());
}

TEST(RunsFolder, NeverReplacesAFileOfOthers) {
  const TemporaryFolder temporary;
  temporary.put("all/summary.json", "mine");
  OutputRequest request = runs_request(temporary.path() / "all");
  request.force = true;
  RunsFolder folder(request, seeds(1));
  EXPECT_TRUE(contains(error_of([&] { folder.put("summary.json", "ours"); }), "did not write"));
  EXPECT_EQ(read_file(temporary.path() / "all/summary.json"), "mine");
}

TEST(FreeFolder, KeepsRunsWithOtherSettingsApart) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "seed-1";
  const OutputRequest request{path, "run", "0123456789abcdef"};
  EXPECT_EQ(free_folder(request), path);
  write_run_of_many(temporary.path(), {"seed-1", "0123456789abcdef"});
  EXPECT_EQ(free_folder(request), path);
  const OutputRequest other{path, "run", "fedcba9876543210"};
  EXPECT_EQ(free_folder(other), temporary.path() / "seed-1-fedcba98");
}

TEST(FreeFolder, LeavesAFolderWithFilesOfOthersOrAnInput) {
  const TemporaryFolder temporary;
  const fs::path path = temporary.path() / "seed-1";
  OutputRequest request{path, "run", "0123456789abcdef"};
  request.inputs = {path / "scenario.yaml"};
  write_run_of_many(temporary.path(), {"seed-1", "0123456789abcdef"});
  EXPECT_EQ(free_folder(request), temporary.path() / "seed-1-01234567");
  request.inputs.clear();
  temporary.put("seed-1/mine.txt", "mine");
  EXPECT_EQ(free_folder(request), temporary.path() / "seed-1-01234567");
}

TEST(FreeRunsFolder, KeepsRunsWithOtherSettingsApart) {
  const TemporaryFolder temporary;
  const OutputRequest request = runs_request(temporary.path() / "lab");
  write_run_of_many(temporary.path() / "lab", seeds(2)[1]);
  EXPECT_EQ(announced_free_runs_folder(request, seeds(2)), temporary.path() / "lab");
  EXPECT_EQ(announced_free_runs_folder(request, seeds(2, "t")), temporary.path() / "lab-all");
}

}  // namespace
}  // namespace castaway::testbed
