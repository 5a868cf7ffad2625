#include "tools/base/formats/points/ply_header.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

std::optional<ScalarType> ply_type(std::string_view word) {
  using enum ScalarKind;
  constexpr std::array<std::pair<std::string_view, ScalarType>, 16> kTypes{{
      {"char", {kSigned, 1}},
      {"int8", {kSigned, 1}},
      {"uchar", {kUnsigned, 1}},
      {"uint8", {kUnsigned, 1}},
      {"short", {kSigned, 2}},
      {"int16", {kSigned, 2}},
      {"ushort", {kUnsigned, 2}},
      {"uint16", {kUnsigned, 2}},
      {"int", {kSigned, 4}},
      {"int32", {kSigned, 4}},
      {"uint", {kUnsigned, 4}},
      {"uint32", {kUnsigned, 4}},
      {"float", {kFloat, 4}},
      {"float32", {kFloat, 4}},
      {"double", {kFloat, 8}},
      {"float64", {kFloat, 8}},
  }};
  for (const auto& [name, type] : kTypes) {
    if (name == word) return type;
  }
  return std::nullopt;
}

std::optional<PlyFormat> ply_format(std::string_view word) {
  if (word == "ascii") return PlyFormat::kAscii;
  if (word == "binary_little_endian") return PlyFormat::kLittleEndian;
  if (word == "binary_big_endian") return PlyFormat::kBigEndian;
  return std::nullopt;
}

/// Takes the lines of a header.
class PlyHeaderReader {
 public:
  explicit PlyHeaderReader(CloudInput& input) : input_(input) {}

  PlyHeader read() {
    CloudWords first(input_.line());
    if (first.next() != "ply" || !first.next().empty()) {
      input_.fail_in_line("no PLY: its first line must be 'ply', and its lines end in LF or CR LF");
    }
    while (true) {
      CloudWords words(input_.line());
      const std::string_view key = words.next();
      if (key == "end_header") return finish();
      read_entry(key, words);
    }
  }

 private:
  void read_entry(std::string_view key, CloudWords& words) {
    if (key == "comment" || key == "obj_info") return;
    if (key == "format") return read_format(words);
    if (key == "element") return read_element(words);
    if (key == "property") return read_property(words);
    input_.fail_in_line(fmt::format("no entry of a PLY header: {}; remove it", quote_word(key)));
  }

  void read_format(CloudWords& words) {
    const std::string_view name = words.next();
    format_ = ply_format(name);
    const std::string_view version = words.next();
    if (format_ && version == "1.0") return;
    input_.fail_in_line(
        fmt::format("format {} {} is not supported; save it as ascii 1.0, binary_little_endian 1.0 "
                    "or binary_big_endian 1.0",
                    quote_word(name), quote_word(version)));
  }

  void read_element(CloudWords& words) {
    const std::string_view name = words.next();
    const std::string_view word = words.next();
    const std::optional<std::uint32_t> count = parse_count(word);
    if (!count) {
      input_.fail_in_line(fmt::format("element {} has the count {}; write a number from 0 to 2^32",
                                      quote_word(name), quote_word(word)));
    }
    elements_.push_back({std::string(name), *count});
  }

  void read_property(CloudWords& words) {
    if (elements_.empty()) input_.fail_in_line("a property before the first element; move it");
    PlyProperty property;
    std::string_view word = words.next();
    if (word == "list") {
      property.list_count = type_of(words.next());
      if (property.list_count->kind == ScalarKind::kFloat) {
        input_.fail_in_line("the length of a list is a float; save it with lists of length uchar");
      }
      word = words.next();
    }
    property.type = type_of(word);
    property.name = words.next();
    elements_.back().properties.push_back(std::move(property));
  }

  [[nodiscard]] ScalarType type_of(std::string_view word) const {
    if (const std::optional<ScalarType> type = ply_type(word)) return *type;
    input_.fail_in_line(
        fmt::format("no type of PLY: {}; write e.g. float, double or uchar", quote_word(word)));
  }

  PlyHeader finish() {
    if (!format_) input_.fail("its header states no format; add the line 'format ascii 1.0'");
    const auto vertex =
        std::find_if(elements_.begin(), elements_.end(),
                     [](const PlyElement& element) { return element.name == "vertex"; });
    if (vertex == elements_.end()) {
      input_.fail("has no element 'vertex'; save the points as vertices");
    }
    std::vector<int> axes;
    for (const PlyProperty& property : vertex->properties) axes.push_back(axis_of(property));
    input_.require_xyz(axes);
    return {*format_, {elements_.begin(), vertex}, *vertex};
  }

  CloudInput& input_;
  std::optional<PlyFormat> format_;
  std::vector<PlyElement> elements_;
};

}  // namespace

int axis_of(const PlyProperty& property) {
  return property.list_count ? -1 : axis_of(property.name);
}

PlyHeader read_ply_header(CloudInput& input) { return PlyHeaderReader(input).read(); }

}  // namespace castaway::testbed
