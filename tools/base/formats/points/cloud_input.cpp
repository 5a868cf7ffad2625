#include "tools/base/formats/points/cloud_input.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr std::string_view kWordBlanks = " \t\r\v\f";

}  // namespace

std::string_view CloudWords::next() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kWordBlanks), rest_.size()));
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kWordBlanks));
  rest_.remove_prefix(word.size());
  return word;
}

std::string quote_word(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + "'";
}

int axis_of(std::string_view name) {
  if (name.size() != 1 || name[0] < 'x' || name[0] > 'z') return -1;
  return name[0] - 'x';
}

CloudInput::CloudInput(std::string_view bytes, std::string name)
    : rest_(bytes), name_(std::move(name)) {}

std::string_view CloudInput::line() {
  while (!rest_.empty()) {
    const std::string_view line = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    ++line_number_;
    if (line.find_first_not_of(kWordBlanks) != std::string_view::npos) return line;
  }
  fail(fmt::format("cut short after line {}; copy the file again", line_number_));
}

std::string_view CloudInput::take(std::uint64_t count, std::uint64_t size) {
  require(count, size);
  const std::string_view part = rest_.substr(0, count * size);
  rest_.remove_prefix(part.size());
  return part;
}

void CloudInput::require(std::uint64_t count, std::uint64_t size) const {
  assert(size > 0);
  if (rest_.size() / size >= count) return;
  fail(fmt::format("cut short: {} x {} bytes are announced, {} remain; copy the file again", count,
                   size, rest_.size()));
}

void CloudInput::require_xyz(const std::vector<int>& axes) const {
  for (const int axis : {0, 1, 2}) {
    const auto fields = std::count(axes.begin(), axes.end(), axis);
    if (fields == 1) continue;
    fail(fmt::format("{} fields are named '{}'; a point needs one x, one y and one z", fields,
                     "xyz"[axis]));
  }
}

void CloudInput::fail(const std::string& what) const {
  throw std::runtime_error(fmt::format("{}: {}", name_, what));
}

void CloudInput::fail_in_line(const std::string& what) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", name_, line_number_, what));
}

}  // namespace castaway::testbed
