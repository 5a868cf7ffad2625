/// What a live run told so far, for pages that open later.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace castaway::testbed {

/// The scans of a run, or its events, which have the numbers 0, 1, 2... The oldest ones are given
/// up.
class LiveHistory {
 public:
  /// Keeps at most so many; `said` and `key`: names in the messages {"said": said, "first": number
  /// of the first one, key: [...]}.
  LiveHistory(std::string said, std::string key, std::size_t most)
      : said_(std::move(said)), key_(std::move(key)), most_(most) {}

  /// Takes those of a message, or of the head of a frame. They, and nothing more, follow the one
  /// before the first of them: what came later of a run that went back never happened.
  void add(const nlohmann::ordered_json& told);
  void clear() { rows_.clear(); }

  /// The message with all of them; empty if there is none.
  [[nodiscard]] std::string message() const;
  /// The message with those of a frame's head alone; empty if it has none.
  [[nodiscard]] std::string message_of(const nlohmann::ordered_json& told) const;
  [[nodiscard]] std::size_t size() const { return rows_.size(); }

 private:
  [[nodiscard]] std::string begin_message(std::size_t first) const;

  std::string said_;
  std::string key_;
  std::size_t most_;
  std::size_t first_ = 0;         ///< Number of the first one.
  std::deque<std::string> rows_;  ///< JSON.
};

/// The JSON of a frame (`LiveFeed::take_frame`); null if it is none.
nlohmann::ordered_json head_of_frame(std::string_view frame);

}  // namespace castaway::testbed
