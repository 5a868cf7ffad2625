#include "tools/batch/cluster/repeated_command.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <regex>
#include <string_view>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/batch/cluster/command_output.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

using Names = std::initializer_list<std::string_view>;

bool is_one_of(std::string_view word, Names names) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

/// True for "-j4", where `names` has "-j".
bool has_value_behind(std::string_view word, Names names) {
  return word.size() > 2 && word[1] != '-' && is_one_of(word.substr(0, 2), names);
}

/// The words without these flags and without these options and their values.
std::vector<std::string> without(const std::vector<std::string>& words, Names flags,
                                 Names options) {
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    const std::string_view name = word.substr(0, word.find('='));
    if (!word.starts_with('-')) {
      kept.push_back(words[i]);
    } else if (is_one_of(word, options)) {
      ++i;  // Its value.
    } else if (!is_one_of(word, flags) && !is_one_of(name, options) &&
               !has_value_behind(word, options)) {
      kept.push_back(words[i]);
    }
  }
  return kept;
}

void hash_files(const fs::path& path, std::map<fs::path, std::string>& hashes) {
  std::error_code none;
  if (fs::is_regular_file(path, none)) {
    hashes[path] = sha256_of_file(path);
  } else if (fs::is_directory(path, none)) {
    for (const auto& entry : fs::recursive_directory_iterator(path, none)) {
      if (entry.is_regular_file(none)) hashes[entry.path()] = sha256_of_file(entry.path());
    }
  }
}

}  // namespace

std::vector<std::string> own_words() {
  std::ifstream stream("/proc/self/cmdline", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    words.emplace_back(text.c_str() + begin);
    begin += words.back().size() + 1;
  }
  if (!words.empty()) words.erase(words.begin());
  return words;
}

std::vector<std::string> shared_words(const std::vector<std::string>& words) {
  return without(
      words, {"--slurm", "--attach", "--collect", "--rank", "--json"},
      {"--partition", "--time", "--array-size", "--sbatch", "--shard", "--metric", "-j", "--jobs"});
}

std::vector<std::string> asked_words(const std::vector<std::string>& words) {
  return without(shared_words(words), {"--retry-failed", "--force", "--verbose"}, {"--out"});
}

std::string command_of_seed(const std::vector<std::string>& words, std::uint64_t seed) {
  static const std::regex plain(R"([\w./:=@%+,-]+)");
  std::string line = "castaway";
  for (const std::string& word :
       without(asked_words(words), {}, {"--seeds", "--seed", "--junit", "--markdown"})) {
    line += " " + (std::regex_match(word, plain) ? word : shell_word(word));
  }
  return line + " --seed " + std::to_string(seed) + " --out look";
}

std::string hash_of_named_files(const std::vector<std::string>& words) {
  std::map<fs::path, std::string> hashes;
  for (const std::string& word : words) {
    hash_files(word, hashes);
    const std::size_t equals = word.find('=');
    if (word.starts_with('-') && equals != std::string::npos) {
      hash_files(word.substr(equals + 1), hashes);
    }
  }
  std::string all;
  for (const auto& [file, hash] : hashes) all += file.string() + " " + hash + "\n";
  return sha256(all);
}

}  // namespace castaway::testbed
