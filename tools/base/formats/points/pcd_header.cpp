#include "tools/base/formats/points/pcd_header.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr std::uint32_t kMostNumbersPerField = 1000000;

std::optional<ScalarKind> pcd_kind(std::string_view word) {
  if (word == "F") return ScalarKind::kFloat;
  if (word == "I") return ScalarKind::kSigned;
  if (word == "U") return ScalarKind::kUnsigned;
  return std::nullopt;
}

std::optional<PcdData> pcd_data(std::string_view word) {
  if (word == "ascii") return PcdData::kAscii;
  if (word == "binary") return PcdData::kBinary;
  if (word == "binary_compressed") return PcdData::kCompressed;
  return std::nullopt;
}

/// Takes the lines of a header.
class PcdHeaderReader {
 public:
  explicit PcdHeaderReader(CloudInput& input) : input_(input) {}

  PcdHeader read() {
    while (!data_) {
      CloudWords words(input_.line());
      read_entry(words.next(), words);
    }
    header_.data = *data_;
    header_.points = point_count();
    check_fields();
    return std::move(header_);
  }

 private:
  void read_entry(std::string_view key, CloudWords& words) {
    if (key.starts_with('#') || key == "VERSION" || key == "VIEWPOINT") return;
    if (key == "FIELDS" || key == "COLUMNS") return read_names(words);
    if (key == "SIZE" || key == "TYPE" || key == "COUNT") return read_of_fields(key, words);
    if (key == "DATA") return read_data(words);
    read_number(key, words);
  }

  void read_data(CloudWords& words) {
    const std::string_view word = words.next();
    data_ = pcd_data(word);
    if (data_) return;
    input_.fail_in_line(
        fmt::format("DATA is {}; write ascii, binary or binary_compressed", quote_word(word)));
  }

  void read_number(std::string_view key, CloudWords& words) {
    const std::string_view word = words.next();
    const std::optional<std::uint32_t> number = parse_count(word);
    if (key == "WIDTH") {
      width_ = number;
    } else if (key == "HEIGHT") {
      height_ = number;
    } else if (key == "POINTS") {
      points_ = number;
    } else {
      input_.fail_in_line(fmt::format("no entry of a PCD header: {}; remove it", quote_word(key)));
    }
    if (number) return;
    input_.fail_in_line(fmt::format("{} is {}; write a number", key, quote_word(word)));
  }

  void read_names(CloudWords& words) {
    if (!header_.fields.empty()) input_.fail_in_line("FIELDS is stated twice; remove one");
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      header_.fields.push_back({.name = std::string(word)});
    }
  }

  void read_of_fields(std::string_view key, CloudWords& words) {
    for (PcdField& field : header_.fields) {
      const std::string_view word = words.next();
      if (set(field, key, word)) continue;
      input_.fail_in_line(fmt::format("{} of field {} is {}; write {}", key, quote_word(field.name),
                                      quote_word(word),
                                      key == "SIZE"   ? "1, 2, 4 or 8"
                                      : key == "TYPE" ? "F, I or U"
                                                      : "0 to 1000000"));
    }
    if (words.next().empty()) return;
    input_.fail_in_line(fmt::format("more values than the {} of FIELDS, which is stated before {}",
                                    header_.fields.size(), key));
  }

  /// Sets what `key` states; false if `word` is no valid value.
  static bool set(PcdField& field, std::string_view key, std::string_view word) {
    if (key == "TYPE") {
      const std::optional<ScalarKind> kind = pcd_kind(word);
      field.type.kind = kind.value_or(ScalarKind::kFloat);
      return kind.has_value();
    }
    const std::uint32_t number = parse_count(word).value_or(UINT32_MAX);
    if (key == "COUNT") {
      field.count = number;
      return number <= kMostNumbersPerField;
    }
    field.type.size = number;
    return number == 1 || number == 2 || number == 4 || number == 8;
  }

  [[nodiscard]] std::uint64_t point_count() const {
    if (!points_ && !width_) input_.fail("its header states no POINTS; add this line before DATA");
    if (!width_) return *points_;
    const std::uint64_t area = *width_ * height_.value_or(1);
    if (points_.value_or(area) == area) return area;
    input_.fail(
        fmt::format("POINTS is {}, but WIDTH x HEIGHT is {}; correct the header", *points_, area));
  }

  void check_fields() const {
    std::vector<int> axes;
    for (const PcdField& field : header_.fields) {
      axes.push_back(axis_of(field.name));
      if (axes.back() < 0) continue;
      const bool is_known = field.type.kind != ScalarKind::kFloat || field.type.size >= 4;
      if (is_known && field.count == 1) continue;
      input_.fail(
          fmt::format("field '{}' has SIZE {} and COUNT {}; a TYPE F has SIZE 4 or 8, and "
                      "x, y and z have COUNT 1",
                      field.name, field.type.size, field.count));
    }
    input_.require_xyz(axes);
  }

  CloudInput& input_;
  PcdHeader header_;
  std::optional<std::uint64_t> width_;
  std::optional<std::uint64_t> height_;
  std::optional<std::uint64_t> points_;
  std::optional<PcdData> data_;
};

}  // namespace

PcdHeader read_pcd_header(CloudInput& input) { return PcdHeaderReader(input).read(); }

}  // namespace castaway::testbed
