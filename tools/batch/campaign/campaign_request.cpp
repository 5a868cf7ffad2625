#include "tools/batch/campaign/campaign_request.hpp"

#include <charconv>
#include <stdexcept>
#include <string_view>

namespace castaway::testbed {
namespace {

int shard_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? value : 0;
}

}  // namespace

int shard_of(const CampaignSpec& spec, int cell, int shards) {
  return (spec.until ? cell / spec.samples() : cell) % shards + 1;
}

void parse_shard(const std::string& text, CampaignRequest& request) {
  const std::size_t slash = text.find('/');
  const std::string_view all = text;
  if (slash != std::string::npos) {
    request.shard = shard_number(all.substr(0, slash));
    request.shards = shard_number(all.substr(slash + 1));
    if (request.shard >= 1 && request.shard <= request.shards && request.shards <= 100000) return;
  }
  throw std::invalid_argument("--shard needs I/N, from 1/N to N/N, such as 3/8, not " + text);
}

}  // namespace castaway::testbed
