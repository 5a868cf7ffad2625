#include "tools/batch/campaign/campaign_folder.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

const CampaignIdentity kIdentity{"1.0", "program", "data", "spec"};

void put_table(CampaignFolder& folder, const std::string& text) {
  folder.put("results.csv", [&](const fs::path& file) { write_file(file, text); });
}

TEST(CampaignFolder, ReplacesItsOwnTables) {
  const TemporaryFolder temporary;
  CampaignFolder folder(temporary.path() / "c", kIdentity);
  put_table(folder, "one");
  put_table(folder, "two");
  EXPECT_EQ(read_file(folder.path() / "results.csv"), "two");
  temporary.put("c/results.csv", "mine");
  EXPECT_TRUE(contains(error_of([&] { put_table(folder, "three"); }), "did not write it"));
  EXPECT_EQ(read_file(folder.path() / "results.csv"), "mine");
}

TEST(CampaignFolder, WritesThroughNoLink) {
  const TemporaryFolder temporary;
  temporary.put("mine", "mine");
  CampaignFolder folder(temporary.path() / "c", kIdentity);
  fs::create_symlink("../mine", temporary.path() / "c/.results.csv.part");
  folder.put("results.csv", [](const fs::path& file) { std::ofstream(file) << "one"; });
  EXPECT_EQ(read_file(temporary.path() / "mine"), "mine");
  EXPECT_EQ(read_file(folder.path() / "results.csv"), "one");
  fs::remove(folder.path() / ".tables.json");
  fs::create_symlink("../mine", folder.path() / ".tables.json");
  EXPECT_TRUE(contains(error_of([&] { CampaignFolder(temporary.path() / "c", kIdentity); }),
                       ".tables.json: is a link"));
}

TEST(CampaignFolder, RefusesADamagedListInOneLine) {
  const TemporaryFolder temporary;
  CampaignFolder folder(temporary.path() / "c", kIdentity);
  for (const char* text : {"[]", "3", "{\"results.csv\": 3}", "{\"a\": null}"}) {
    temporary.put("c/.tables.json", text);
    EXPECT_TRUE(contains(error_of([&] { put_table(folder, "one"); }),
                         ".tables.json: is not castaway's list of the campaign's tables"));
  }
}

}  // namespace
}  // namespace castaway::testbed
