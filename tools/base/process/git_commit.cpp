#include "tools/base/process/git_commit.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

std::string first_line(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// What follows `key` in a file's only line; empty if it begins otherwise.
std::string value_of(const std::string& line, const std::string& key) {
  return line.starts_with(key) ? line.substr(key.size()) : std::string();
}

bool is_commit(const std::string& text) {
  const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
  return text.size() >= 40 && std::all_of(text.begin(), text.end(), is_digit);
}

/// The `.git` of the innermost repository around `folder`, a link to another place followed.
fs::path repository_of(fs::path folder) {
  std::error_code none;
  for (; !fs::exists(folder / ".git", none); folder = folder.parent_path()) {
    if (folder == folder.parent_path()) return {};
  }
  const fs::path git = folder / ".git";
  return fs::is_directory(git, none) ? git : folder / value_of(first_line(git), "gitdir: ");
}

std::string find_packed_ref(const fs::path& shared, const std::string& ref) {
  std::ifstream refs(shared / "packed-refs");
  for (std::string line; std::getline(refs, line);) {
    const std::size_t space = line.find(' ');
    if (space != std::string::npos && line.substr(space + 1) == ref) return line.substr(0, space);
  }
  return {};
}

std::string commit_of_ref(const fs::path& git, const std::string& ref) {
  const std::string common = first_line(git / "commondir");
  const fs::path shared = common.empty() ? git : git / common;
  const std::string loose = first_line(shared / ref);
  return loose.empty() ? find_packed_ref(shared, ref) : loose;
}

}  // namespace

std::string git_commit(const fs::path& folder) {
  std::error_code none;
  const fs::path git = repository_of(fs::absolute(folder, none));
  if (git.empty()) return {};
  const std::string head = first_line(git / "HEAD");
  const std::string ref = value_of(head, "ref: ");
  const std::string commit = ref.empty() ? head : commit_of_ref(git, ref);
  return is_commit(commit) ? commit.substr(0, 12) : std::string();
}

}  // namespace castaway::testbed
