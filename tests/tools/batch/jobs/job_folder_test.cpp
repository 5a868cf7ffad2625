#include "tools/batch/jobs/job_folder.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

const JobIdentity kIdentity{"campaign", "1.0", "program", "data", "spec"};

void put_table(JobFolder& folder, const std::string& text) {
  folder.put("results.csv", [&](const fs::path& file) { write_file(file, text); });
}

TEST(JobFolder, ReplacesItsOwnTables) {
  const TemporaryFolder temporary;
  JobFolder folder(temporary.path() / "c", kIdentity);
  put_table(folder, "one");
  put_table(folder, "two");
  EXPECT_EQ(read_file(folder.path() / "results.csv"), "two");
  temporary.put("c/results.csv", "mine");
  EXPECT_TRUE(contains(error_of([&] { put_table(folder, "three"); }), "castaway did not write it"));
  EXPECT_EQ(read_file(folder.path() / "results.csv"), "mine");
}

TEST(JobFolder, WritesThroughNoLink) {
  const TemporaryFolder temporary;
  temporary.put("mine", "mine");
  JobFolder folder(temporary.path() / "c", kIdentity);
  fs::create_symlink("../mine", temporary.path() / "c/results.csv");
  EXPECT_TRUE(contains(error_of([&] { put_table(folder, "one"); }), "castaway did not write it"));
  EXPECT_EQ(read_file(temporary.path() / "mine"), "mine");
  fs::remove(folder.path() / ".castaway.json");
  fs::create_symlink("../mine", folder.path() / ".castaway.json");
  EXPECT_TRUE(contains(error_of([&] { put_table(folder, "one"); }), ".castaway.json: is a link"));
}

TEST(JobFolder, RefusesADamagedListInOneLine) {
  const TemporaryFolder temporary;
  JobFolder folder(temporary.path() / "c", kIdentity);
  for (const char* text : {"[]", "3", R"({"castaway": "1", "files": {"results.csv": 3}})"}) {
    temporary.put("c/.castaway.json", text);
    EXPECT_TRUE(contains(error_of([&] { put_table(folder, "one"); }),
                         ".castaway.json: is not castaway's list"));
  }
}

TEST(JobFolder, NoticesThatItsSpecificationWasChanged) {
  const TemporaryFolder temporary;
  const fs::path place = temporary.path() / "c";
  static_cast<void>(JobFolder(place, kIdentity));
  temporary.put("c/campaign.yaml", "spec of another");
  EXPECT_TRUE(contains(error_of([&] { JobFolder(place, kIdentity); }),
                       "campaign.yaml: was changed since castaway wrote it"));
  fs::remove(place / "campaign.yaml");
  static_cast<void>(JobFolder(place, kIdentity));
  EXPECT_EQ(read_file(place / "campaign.yaml"), "spec");
}

}  // namespace
}  // namespace castaway::testbed
