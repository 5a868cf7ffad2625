/// Recognises pointers that Git LFS leaves in place of large files.
#pragma once

#include <string_view>

namespace castaway {

/// Says what such a file is, and what to do, after "path: ".
inline constexpr std::string_view kGitLfsPointer =
    "only a Git LFS pointer: git lfs pull fetches the file";

/// True for the first bytes of a pointer.
inline bool is_git_lfs_pointer(std::string_view head) {
  return head.starts_with("version https://git-lfs.github.com/spec/");
}

}  // namespace castaway
