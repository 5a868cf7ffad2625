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
  EXPECT_TRUE(contains(error_of([&] { put_table(folder, "three"); }), "castaway did not write it"));
  EXPECT_EQ(read_file(folder.path() / "results.csv"), "mine");
}

TEST(CampaignFolder, WritesThroughNoLink) {
  const TemporaryFolder temporary;
  temporary.put("mine", "mine");
  CampaignFolder folder(temporary.path() / "c", kIdentity);
  fs::create_symlink("../mine", temporary.path() / "c/results.csv");
  EXPECT_TRUE(contains(error_of([&] { put_table(folder, "one"); }), "castaway did not write it"));
  EXPECT_EQ(read_file(temporary.path() / "mine"), "mine");
  fs::remove(folder.path() / ".castaway.json");
  fs::create_symlink("../mine", folder.path() / ".castaway.json");
  EXPECT_TRUE(contains(error_of([&] { put_table(folder, "one"); }), ".castaway.json: is a link"));
}

TEST(CampaignFolder, RefusesADamagedListInOneLine) {
  const TemporaryFolder temporary;
  CampaignFolder folder(temporary.path() / "c", kIdentity);
  for (const char* text : {"[]", "3", R"({"castaway": "1", "files": {"results.csv": 3}})"}) {
    temporary.put("c/.castaway.json", text);
    EXPECT_TRUE(contains(error_of([&] { put_table(folder, "one"); }),
                         ".castaway.json: is not castaway's list"));
  }
}

TEST(CampaignFolder, NoticesThatItsSpecificationWasChanged) {
  const TemporaryFolder temporary;
  const fs::path place = temporary.path() / "c";
  static_cast<void>(CampaignFolder(place, kIdentity));
  temporary.put("c/campaign.yaml", "spec of another");
  EXPECT_TRUE(contains(error_of([&] { CampaignFolder(place, kIdentity); }),
                       "campaign.yaml: was changed since castaway wrote it"));
  fs::remove(place / "campaign.yaml");
  static_cast<void>(CampaignFolder(place, kIdentity));
  EXPECT_EQ(read_file(place / "campaign.yaml"), "spec");
}

}  // namespace
}  // namespace castaway::testbed
