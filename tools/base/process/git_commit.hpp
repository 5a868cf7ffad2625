/// The commit that a folder's git repository is at, read without git.
#pragma once

#include <filesystem>
#include <string>

namespace castaway::testbed {

/// The first 12 digits of the commit checked out where `folder` lies, in a work tree of `git
/// worktree`, too. Empty if it lies in no repository or the repository has no commit. Says nothing
/// about files that were changed since. Layout: gitrepository-layout(5).
std::string git_commit(const std::filesystem::path& folder);

}  // namespace castaway::testbed
