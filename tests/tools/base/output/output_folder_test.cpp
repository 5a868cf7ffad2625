#include "tools/base/output/output_folder.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

OutputRequest request_for(const fs::path& target) { return {target, "run", "5e77"}; }

/// Writes a complete run with these files.
void write_run(const fs::path& target, const std::vector<std::string>& files) {
  OutputFolder output(request_for(target));
  for (const std::string& file : files) write_file(output.folder() / file, file);
  output.commit();
}

std::string refusal(const OutputRequest& request) {
  return error_of([&] { OutputFolder output(request); });
}

TEST(OutputFolder, AppearsWhenItIsComplete) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "a/b/run";
  {
    OutputFolder output(request_for(target));
    write_file(output.folder() / "bag/x.mcap", "x");
    EXPECT_FALSE(fs::exists(target / "bag"));
    output.commit();
  }
  EXPECT_EQ(read_file(target / "bag/x.mcap"), "x");
  EXPECT_FALSE(fs::exists(target / kStagingName));
  EXPECT_TRUE(load_record(target).value().finished);
}

TEST(OutputFolder, SaysThatItIsIncomplete) {
  const TemporaryFolder folder;
  OutputFolder output(request_for(folder.path() / "run"));
  write_file(output.folder() / "errors.csv", "e");
  EXPECT_FALSE(output.is_committed());
  output.commit(false);
  EXPECT_TRUE(output.is_committed());
  EXPECT_FALSE(load_record(folder.path() / "run").value().finished);
  EXPECT_EQ(read_file(folder.path() / "run/errors.csv"), "e");
}

TEST(OutputFolder, LeavesNothingUnlessItIsComplete) {
  const TemporaryFolder folder;
  { const OutputFolder output(request_for(folder.path() / "a/b/run")); }
  EXPECT_FALSE(fs::exists(folder.path() / "a"));
}

TEST(OutputFolder, KeepsAnEmptyFolderThatWasThere) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "a");
  { const OutputFolder output(request_for(folder.path() / "a")); }
  EXPECT_TRUE(fs::is_empty(folder.path() / "a"));
}

TEST(OutputFolder, RemovesTheFilesOfTheRunBefore) {
  const TemporaryFolder folder;
  write_run(folder.path() / "run", {"errors.csv", "tables/a.csv", "amcl.tum"});
  write_run(folder.path() / "run", {"errors.csv", "mh_amcl.tum"});
  EXPECT_FALSE(fs::exists(folder.path() / "run/tables"));
  EXPECT_FALSE(fs::exists(folder.path() / "run/amcl.tum"));
  EXPECT_TRUE(fs::exists(folder.path() / "run/mh_amcl.tum"));
}

TEST(OutputFolder, KeepsTheRunBeforeIfItFails) {
  const TemporaryFolder folder;
  write_run(folder.path() / "run", {"errors.csv"});
  {
    const OutputFolder output(request_for(folder.path() / "run"));
    write_file(output.folder() / "half", "h");
  }
  EXPECT_TRUE(fs::exists(folder.path() / "run/errors.csv"));
  EXPECT_FALSE(fs::exists(folder.path() / "run/half"));
  EXPECT_FALSE(find_foreign(folder.path() / "run", load_record(folder.path() / "run")));
}

TEST(OutputFolder, RefusesAFolderWithFilesOfOthers) {
  const TemporaryFolder folder;
  folder.put("run/bag/mine.mcap", "mine");
  const std::string text = refusal(request_for(folder.path() / "run"));
  EXPECT_TRUE(
      contains(text, "holds 'bag/mine.mcap', which castaway did not write; choose another"));
  EXPECT_TRUE(contains(text, "--force"));
}

TEST(OutputFolder, RefusesAFolderWithAFileThatWasChanged) {
  const TemporaryFolder folder;
  write_run(folder.path() / "run", {"errors.csv"});
  folder.put("run/errors.csv", "mine");
  EXPECT_TRUE(contains(refusal(request_for(folder.path() / "run")),
                       "'errors.csv' was changed since castaway wrote it"));
}

TEST(OutputFolder, RefusesAFolderWithAnInputEvenByForce) {
  const TemporaryFolder folder;
  write_run(folder.path() / "run", {"bag/x.mcap"});
  OutputRequest request = request_for(folder.path() / "run");
  request.inputs = {folder.path() / "run/bag"};
  request.force = true;
  EXPECT_TRUE(contains(refusal(request), "holds the input"));
  request.inputs = {folder.path() / "run"};
  EXPECT_TRUE(contains(refusal(request), "holds the input"));
  request.inputs = {folder.path() / "running.yaml"};
  EXPECT_NO_THROW(check_output(request));
}

TEST(OutputFolder, SeesAnInputThroughALink) {
  const TemporaryFolder folder;
  folder.put("run/log.carmen", "log");
  fs::create_symlink(folder.path() / "run/log.carmen", folder.path() / "link");
  OutputRequest request = request_for(folder.path() / "run");
  request.inputs = {folder.path() / "link"};
  request.force = true;
  EXPECT_TRUE(contains(refusal(request), "holds the input"));
}

TEST(OutputFolder, ReplacesOnlyItsOwnByForce) {
  const TemporaryFolder folder;
  write_run(folder.path() / "run", {"errors.csv", "old.csv"});
  folder.put("run/mine.txt", "mine");
  OutputRequest request = request_for(folder.path() / "run");
  request.force = true;
  {
    OutputFolder output(request);
    write_file(output.folder() / "errors.csv", "new");
    output.commit();
  }
  EXPECT_EQ(read_file(folder.path() / "run/errors.csv"), "new");
  EXPECT_EQ(read_file(folder.path() / "run/mine.txt"), "mine");
  EXPECT_FALSE(fs::exists(folder.path() / "run/old.csv"));
}

TEST(OutputFolder, NeverTakesThePlaceOfAFileOfOthers) {
  const TemporaryFolder folder;
  write_run(folder.path() / "run", {"old.csv"});
  folder.put("run/errors.csv", "mine");
  OutputRequest request = request_for(folder.path() / "run");
  request.force = true;
  OutputFolder output(request);
  write_file(output.folder() / "errors.csv", "new");
  EXPECT_TRUE(contains(error_of([&] { output.commit(); }), "castaway did not write what is there"));
  EXPECT_EQ(read_file(folder.path() / "run/errors.csv"), "mine");
  EXPECT_TRUE(fs::exists(folder.path() / "run/old.csv"));
}

TEST(OutputFolder, WritesThroughNoLink) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "elsewhere");
  fs::create_directories(folder.path() / "run");
  fs::create_directory_symlink(folder.path() / "elsewhere", folder.path() / "run/bag");
  OutputRequest request = request_for(folder.path() / "run");
  EXPECT_TRUE(contains(refusal(request), "holds 'bag'"));
  request.force = true;
  OutputFolder output(request);
  write_file(output.folder() / "bag/x.mcap", "x");
  EXPECT_TRUE(contains(error_of([&] { output.commit(); }), "castaway did not write what is there"));
  EXPECT_TRUE(fs::is_empty(folder.path() / "elsewhere"));
}

TEST(OutputFolder, LeavesSingleFilesAlone) {
  const TemporaryFolder folder;
  write_run(folder.path() / "run", {"errors.csv"});
  FileRecord record = load_record(folder.path() / "run").value();
  folder.put("run/junit.xml", "<x/>");
  record.single_files["junit.xml"] = hash_file(folder.path() / "run", "junit.xml");
  save_record(folder.path() / "run", record);
  write_run(folder.path() / "run", {"errors.csv"});
  EXPECT_TRUE(fs::exists(folder.path() / "run/junit.xml"));
  EXPECT_TRUE(load_record(folder.path() / "run").value().single_files.contains("junit.xml"));
}

TEST(OutputFolder, ClearsWhatAKilledRunLeft) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "run";
  const pid_t child = fork();
  if (child == 0) {
    OutputFolder output(request_for(target));
    write_file(output.folder() / "half", "h");
    _exit(0);  // Simulates a kill: nothing is cleaned up.
  }
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(fs::exists(target / kStagingName / "half"));
  write_run(target, {"errors.csv"});
  EXPECT_FALSE(fs::exists(target / kStagingName));
  EXPECT_TRUE(fs::exists(target / "errors.csv"));
}

TEST(OutputFolder, RefusesASecondProcess) {
  const TemporaryFolder folder;
  const OutputFolder output(request_for(folder.path() / "run"));
  EXPECT_TRUE(contains(refusal(request_for(folder.path() / "run")),
                       "another castaway process is using it"));
}

TEST(OutputFolder, RefusesAFile) {
  const TemporaryFolder folder;
  folder.put("run", "a file");
  EXPECT_TRUE(contains(refusal(request_for(folder.path() / "run")), "is not a folder"));
}

TEST(OutputFolder, LeavesNoListInAPartOfALargerFolder) {
  const TemporaryFolder folder;
  OutputRequest request = request_for(folder.path() / "run");
  request.keep_list = false;
  {
    OutputFolder output(request);
    write_file(output.folder() / "errors.csv", "e");
    output.commit();
  }
  EXPECT_FALSE(fs::exists(folder.path() / "run" / kRecordName));
  EXPECT_TRUE(fs::exists(folder.path() / "run/errors.csv"));
}

/// A repository that ships a folder `runs` must not reach the user's files.
TEST(OutputFolder, RemovesNothingForAListFromOutside) {
  const TemporaryFolder folder;
  const fs::path thesis = folder.put("docs/thesis.tex", "mine");
  folder.put("run/notes.txt", "mine");
  const std::string hash = "\": \"" + hash_file(folder.path(), "docs/thesis.tex") + "\"";
  const std::string none = "\": null";
  for (const std::string& entry :
       {"../docs/thesis.tex" + none, "../docs/thesis.tex" + hash, thesis.string() + none,
        thesis.string() + hash, "a/../../docs/thesis.tex" + hash, "notes.txt" + none}) {
    folder.put("run/" + std::string(kRecordName),
               R"({"castaway": "1", "files": {")" + entry + "}}");
    OutputRequest request = request_for(folder.path() / "run");
    EXPECT_NE(refusal(request), "") << entry;
    request.force = true;
    EXPECT_NE(refusal(request), "") << entry;
    EXPECT_NE(error_of([&] { remove_output(folder.path() / "run"); }), "") << entry;
    EXPECT_EQ(read_file(thesis), "mine");
    EXPECT_EQ(read_file(folder.path() / "run/notes.txt"), "mine");
  }
}

TEST(OutputFolder, RemovesNothingThroughALinkByForce) {
  const TemporaryFolder folder;
  const fs::path thesis = folder.put("docs/thesis.tex", "mine");
  fs::create_directories(folder.path() / "run");
  fs::create_directory_symlink("../docs", folder.path() / "run/link");
  FileRecord record{"run", "5e77", true, {}, {}};
  record.files["link/thesis.tex"] = hash_file(folder.path(), "docs/thesis.tex");
  save_record(folder.path() / "run", record);
  OutputRequest request = request_for(folder.path() / "run");
  request.force = true;
  {
    OutputFolder output(request);
    write_file(output.folder() / "errors.csv", "new");
    output.commit();
  }
  EXPECT_EQ(read_file(thesis), "mine");
}

TEST(OutputFolder, ReplacesWhatAKilledRunMovedHalfWay) {
  const TemporaryFolder folder;
  write_run(folder.path() / "run", {"errors.csv", "old.csv"});
  FileRecord record = load_record(folder.path() / "run").value();
  record.finished = false;
  folder.put("run/errors.csv", "half-way");
  folder.put("run/new.csv", "new");
  for (const char* name : {"errors.csv", "new.csv"}) {
    record.coming[name] = hash_file(folder.path() / "run", name);
  }
  record.coming["later.csv"] = record.files.at("old.csv");
  save_record(folder.path() / "run", record);
  write_run(folder.path() / "run", {"errors.csv"});
  EXPECT_EQ(read_file(folder.path() / "run/errors.csv"), "errors.csv");
  EXPECT_FALSE(fs::exists(folder.path() / "run/new.csv"));
  EXPECT_FALSE(fs::exists(folder.path() / "run/old.csv"));
}

TEST(ReplaceOutput, MovesADraftToAFreePlace) {
  const TemporaryFolder folder;
  write_run(folder.path() / "draft", {"errors.csv", "tables/a.csv"});
  replace_output(folder.path() / "draft", folder.path() / "cells/1");
  EXPECT_EQ(read_file(folder.path() / "cells/1/tables/a.csv"), "tables/a.csv");
  EXPECT_FALSE(fs::exists(folder.path() / "draft"));
}

TEST(ReplaceOutput, KeepsFilesOfOthers) {
  const TemporaryFolder folder;
  write_run(folder.path() / "run", {"errors.csv", "old.csv", "tables/a.csv"});
  folder.put("run/notes.txt", "mine");
  folder.put("run/tables/mine.csv", "mine");
  write_run(folder.path() / "draft", {"errors.csv", "tables/a.csv", "tables/b.csv"});
  replace_output(folder.path() / "draft", folder.path() / "run");
  EXPECT_EQ(read_file(folder.path() / "run/notes.txt"), "mine");
  EXPECT_EQ(read_file(folder.path() / "run/tables/mine.csv"), "mine");
  EXPECT_EQ(read_file(folder.path() / "run/tables/b.csv"), "tables/b.csv");
  EXPECT_FALSE(fs::exists(folder.path() / "run/old.csv"));
  folder.put("run/errors.csv", "mine");
  write_run(folder.path() / "again", {"errors.csv"});
  EXPECT_TRUE(
      contains(error_of([&] { replace_output(folder.path() / "again", folder.path() / "run"); }),
               "castaway did not write what is there"));
  EXPECT_EQ(read_file(folder.path() / "run/errors.csv"), "mine");
}

TEST(ReplaceOutput, FollowsNoLink) {
  const TemporaryFolder folder;
  write_run(folder.path() / "mine", {"errors.csv"});
  write_run(folder.path() / "draft", {"errors.csv"});
  fs::create_directory_symlink("mine", folder.path() / "link");
  EXPECT_TRUE(
      contains(error_of([&] { replace_output(folder.path() / "draft", folder.path() / "link"); }),
               "is a link"));
}

}  // namespace
}  // namespace castaway::testbed
