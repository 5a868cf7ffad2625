#include "tools/base/process/git_commit.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kMainCommit = "0123456789abcdef0123456789abcdef01234567";
constexpr const char* kSideCommit = "fedcba9876543210fedcba9876543210fedcba98";

/// A repository at the branch `main` with `commit`, as `git commit` leaves it.
void make_repository(const std::filesystem::path& folder, const std::string& commit) {
  std::filesystem::create_directories(folder / ".git/refs/heads");
  write_file(folder / ".git/HEAD", "ref: refs/heads/main\n");
  write_file(folder / ".git/refs/heads/main", commit + "\n");
}

TEST(GitCommit, IsThatOfTheBranchFromAnyFolderInside) {
  const TemporaryFolder folder;
  make_repository(folder.path(), kMainCommit);
  std::filesystem::create_directories(folder.path() / "a/b");
  EXPECT_EQ(git_commit(folder.path() / "a/b"), "0123456789ab");
}

TEST(GitCommit, IsReadOfADetachedHead) {
  const TemporaryFolder folder;
  make_repository(folder.path(), kMainCommit);
  write_file(folder.path() / ".git/HEAD", std::string(kSideCommit) + "\n");
  EXPECT_EQ(git_commit(folder.path()), "fedcba987654");
}

TEST(GitCommit, IsReadOfPackedRefs) {
  const TemporaryFolder folder;
  make_repository(folder.path(), kMainCommit);
  std::filesystem::remove(folder.path() / ".git/refs/heads/main");
  write_file(folder.path() / ".git/packed-refs",
             std::string("# pack-refs with: peeled fully-peeled sorted\n") + kMainCommit +
                 " refs/heads/maintenance\n" + kSideCommit + " refs/heads/main\n");
  EXPECT_EQ(git_commit(folder.path()), "fedcba987654");
}

TEST(GitCommit, OfAWorkTreeIsItsOwn) {
  const TemporaryFolder folder;
  make_repository(folder.path() / "main", kMainCommit);
  const auto own = folder.path() / "main/.git/worktrees/other";
  std::filesystem::create_directories(own);
  write_file(own / "HEAD", "ref: refs/heads/side\n");
  write_file(own / "commondir", "../..\n");
  write_file(folder.path() / "main/.git/refs/heads/side", std::string(kSideCommit) + "\n");
  std::filesystem::create_directories(folder.path() / "other");
  write_file(folder.path() / "other/.git", "gitdir: ../main/.git/worktrees/other\n");
  EXPECT_EQ(git_commit(folder.path() / "other"), "fedcba987654");
}

TEST(GitCommit, IsEmptyWithoutOne) {
  const TemporaryFolder folder;
  make_repository(folder.path(), "not a commit");
  EXPECT_EQ(git_commit(folder.path()), "");
  EXPECT_EQ(git_commit("/"), "");
}

}  // namespace
}  // namespace castaway::testbed
