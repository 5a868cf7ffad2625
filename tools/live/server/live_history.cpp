#include "tools/live/server/live_history.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using HistoryJson = nlohmann::ordered_json;

}  // namespace

void LiveHistory::add(const HistoryJson& told) {
  const auto first = told.at("first").get<std::size_t>();
  if (rows_.empty() || first < first_ || first > first_ + rows_.size()) {
    rows_.clear();
    first_ = first;
  }
  rows_.resize(first - first_);
  for (const HistoryJson& row : told.at(key_)) rows_.push_back(json_text(row));
  while (rows_.size() > most_) {
    rows_.pop_front();
    ++first_;
  }
}

std::string LiveHistory::begin_message(std::size_t first) const {
  return fmt::format(R"({{"said":"{}","first":{},"{}":)", said_, first, key_);
}

std::string LiveHistory::message() const {
  if (rows_.empty()) return "";
  return begin_message(first_) + fmt::format("[{}]}}", fmt::join(rows_, ","));
}

std::string LiveHistory::message_of(const HistoryJson& told) const {
  if (told.at(key_).empty()) return "";
  return begin_message(told.at("first").get<std::size_t>()) + json_text(told.at(key_)) + "}";
}

HistoryJson head_of_frame(std::string_view frame) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4 && i < frame.size(); ++i) {
    size |= static_cast<std::size_t>(static_cast<std::uint8_t>(frame[i])) << (8 * i);
  }
  HistoryJson head = HistoryJson::parse(frame.substr(std::min<std::size_t>(4, frame.size()), size),
                                        nullptr, false);
  return head.is_object() && head.contains("first") ? head : HistoryJson();
}

}  // namespace castaway::testbed
