/// Texts whatever their case.
#pragma once

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

namespace castaway {

/// The text with A to Z in lower case.
inline std::string to_lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// True if the text holds one of the words, which are in lower case.
inline bool holds_word(const std::string& text, std::initializer_list<const char*> words) {
  const std::string lower = to_lower(text);
  return std::any_of(words.begin(), words.end(),
                     [&lower](const char* word) { return lower.find(word) != std::string::npos; });
}

}  // namespace castaway
