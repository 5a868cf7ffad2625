#include "tools/base/formats/points/ply.hpp"

#include <bit>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "tools/base/formats/points/ply_header.hpp"

namespace castaway::testbed {
namespace {

/// Values of ascii elements, one element per line.
class PlyTextValues {
 public:
  explicit PlyTextValues(CloudInput& input) : input_(input) {}

  void begin_element() { words_ = CloudWords(input_.line()); }
  void end_element() {
    if (words_.next().empty()) return;
    input_.fail_in_line("more values than its element has properties; correct the header");
  }
  double number(const PlyProperty& property) {
    const std::string_view text = word(property);
    if (const std::optional<double> value = parse_scalar(text)) return *value;
    fail(property, text);
  }
  std::uint64_t list_size(const PlyProperty& property) {
    const std::string_view text = word(property);
    if (const std::optional<std::uint32_t> size = parse_count(text)) return *size;
    fail(property, text);
  }
  void skip(const PlyProperty& property, std::uint64_t numbers) {
    for (std::uint64_t i = 0; i < numbers; ++i) word(property);
  }
  static std::uint64_t least_size(const PlyElement& element) {
    return 2 * element.properties.size() - 1;
  }

 private:
  std::string_view word(const PlyProperty& property) {
    const std::string_view word = words_.next();
    if (!word.empty()) return word;
    input_.fail_in_line(fmt::format("ends before its {}; add it", quote_word(property.name)));
  }
  [[noreturn]] void fail(const PlyProperty& property, std::string_view text) const {
    input_.fail_in_line(fmt::format("{} is {}; write {}", quote_word(property.name),
                                    quote_word(text),
                                    property.list_count ? "the length of the list" : "a number"));
  }

  CloudInput& input_;
  CloudWords words_{""};
};

/// Values of binary elements.
class PlyBinaryValues {
 public:
  PlyBinaryValues(CloudInput& input, std::endian order) : input_(input), order_(order) {}

  void begin_element() {}
  void end_element() {}
  double number(const PlyProperty& property) { return take(property.type); }
  std::uint64_t list_size(const PlyProperty& property) {
    const double size = take(*property.list_count);
    if (size >= 0.0) return static_cast<std::uint64_t>(size);
    input_.fail(fmt::format("a list {} has the length {}; copy the file again",
                            quote_word(property.name), size));
  }
  void skip(const PlyProperty& property, std::uint64_t numbers) {
    input_.take(numbers, property.type.size);
  }
  static std::uint64_t least_size(const PlyElement& element) {
    std::uint64_t size = 0;
    for (const PlyProperty& property : element.properties) {
      size += property.list_count.value_or(property.type).size;
    }
    return size;
  }

 private:
  double take(const ScalarType& type) { return scalar_at(input_.take(1, type.size), type, order_); }

  CloudInput& input_;
  std::endian order_;
};

template <typename Values>
Eigen::Vector3d read_ply_element(const PlyElement& element, Values& values) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  values.begin_element();
  for (const PlyProperty& property : element.properties) {
    const int axis = axis_of(property);
    if (axis >= 0) {
      point[axis] = values.number(property);
    } else {
      values.skip(property, property.list_count ? values.list_size(property) : 1);
    }
  }
  values.end_element();
  return point;
}

template <typename Values>
std::vector<Eigen::Vector3d> read_vertices(const PlyHeader& header, CloudInput& input,
                                           Values values) {
  for (const PlyElement& element : header.skipped) {
    if (element.properties.empty()) continue;
    for (std::uint64_t i = 0; i < element.count; ++i) read_ply_element(element, values);
  }
  input.require(header.vertex.count, Values::least_size(header.vertex));
  std::vector<Eigen::Vector3d> points;
  points.reserve(header.vertex.count);
  for (std::uint64_t i = 0; i < header.vertex.count; ++i) {
    points.push_back(read_ply_element(header.vertex, values));
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector3d> decode_ply(std::string_view bytes, const std::string& name) {
  CloudInput input(bytes, name);
  const PlyHeader header = read_ply_header(input);
  if (header.format == PlyFormat::kAscii) {
    return read_vertices(header, input, PlyTextValues(input));
  }
  const std::endian order =
      header.format == PlyFormat::kBigEndian ? std::endian::big : std::endian::little;
  return read_vertices(header, input, PlyBinaryValues(input, order));
}

}  // namespace castaway::testbed
