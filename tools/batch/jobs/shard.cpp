#include "tools/batch/jobs/shard.hpp"

#include <charconv>
#include <set>
#include <stdexcept>
#include <string_view>

namespace castaway::testbed {
namespace {

constexpr int kMostShards = 100000;

int shard_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? value : 0;
}

}  // namespace

std::vector<int> shards_of(const std::vector<int>& jobs, int count) {
  std::set<int> shards;
  for (const int job : jobs) shards.insert(job % count + 1);
  return {shards.begin(), shards.end()};
}

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string_view all = text;
  if (slash != std::string::npos) {
    const Shard shard{shard_number(all.substr(0, slash)), shard_number(all.substr(slash + 1))};
    if (shard.index >= 1 && shard.index <= shard.count && shard.count <= kMostShards) return shard;
  }
  throw std::invalid_argument("--shard needs I/N, from 1/N to N/N, such as 3/8, not " + text);
}

}  // namespace castaway::testbed
