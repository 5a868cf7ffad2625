#include "tools/batch/dataset/dataset_manifest.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

using Lines = std::vector<std::string>;

void seal(const TemporaryFolder& folder) {
  const auto files = survey_files(folder.path());
  write_file(folder.path() / "manifest.json", manifest_text(files));
  write_file(folder.path() / "SHA256SUMS", sums_text(files));
}

TEST(DatasetManifest, FindsEveryFileInOrder) {
  const TemporaryFolder folder;
  folder.put("b/c.txt", "abc");
  folder.put("a.txt", "");
  const auto files = survey_files(folder.path());
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].path, "a.txt");
  EXPECT_EQ(files[1].path, "b/c.txt");
  EXPECT_EQ(files[1].bytes, 3U);
  EXPECT_EQ(sums_text({files[1]}),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  b/c.txt\n");
}

TEST(DatasetManifest, AgreesWithWhatItWasMadeFrom) {
  const TemporaryFolder folder;
  folder.put("b/c.txt", "abc");
  seal(folder);
  EXPECT_EQ(verify_dataset(folder.path()), Lines{});
}

TEST(DatasetManifest, TellsWhatIsMissingChangedAndMore) {
  const TemporaryFolder folder;
  folder.put("gone", "1");
  folder.put("longer", "2");
  folder.put("other", "3");
  seal(folder);
  std::filesystem::remove(folder.path() / "gone");
  folder.put("longer", "22");
  folder.put("other", "4");
  folder.put("new/x", "5");
  EXPECT_EQ(verify_dataset(folder.path()),
            (Lines{"gone: missing", "longer: changed: 2 bytes instead of 1",
                   "other: changed: SHA-256 4b227777d4dd... instead of 4e07408562be...",
                   "new/x: not listed in manifest.json"}));
}

TEST(DatasetManifest, HoldsTheSumsAgainstItself) {
  const TemporaryFolder folder;
  folder.put("a", "1");
  seal(folder);
  folder.put("SHA256SUMS", "");
  EXPECT_EQ(verify_dataset(folder.path()),
            (Lines{"SHA256SUMS: changed: it does not agree with manifest.json"}));
  std::filesystem::remove(folder.path() / "SHA256SUMS");
  EXPECT_EQ(verify_dataset(folder.path()), (Lines{"SHA256SUMS: missing"}));
}

TEST(DatasetManifest, RefusesWhatIsNone) {
  const TemporaryFolder folder;
  const auto verify = [&] { verify_dataset(folder.path()); };
  EXPECT_TRUE(contains(error_of(verify), "no manifest.json: not a data set, or an unfinished"));
  folder.put("manifest.json", "{\"files\": 3}");
  EXPECT_TRUE(contains(error_of(verify), "manifest.json: no manifest of a data set"));
  folder.put("manifest.json", "{\"files\": [");
  EXPECT_TRUE(contains(error_of(verify), "manifest.json: no manifest of a data set"));
  folder.put("manifest.json",
             "{\"files\": [{\"path\": \"../x\", \"bytes\": 1, \"sha256\": \"\"}]}");
  EXPECT_TRUE(contains(error_of(verify), "lists the path '../x', which leads out"));
}

TEST(DatasetManifest, FollowsNoLink) {
  const TemporaryFolder folder;
  folder.put("b/c.txt", "abc");
  seal(folder);
  std::filesystem::rename(folder.path() / "b", folder.path() / "d");
  std::filesystem::create_directory_symlink("d", folder.path() / "b");
  EXPECT_EQ(verify_dataset(folder.path()).front(), "b/c.txt: is reached by a link");
}

// Its script depends on the build.
TEST(DatasetManifest, LeavesThePageOfPlotsAlone) {
  const TemporaryFolder folder;
  folder.put("a.txt", "abc");
  seal(folder);
  folder.put(kPlotsPage, "any");
  EXPECT_EQ(verify_dataset(folder.path()), Lines{});
}

}  // namespace
}  // namespace castaway::testbed
