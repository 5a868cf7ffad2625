#include "tools/base/formats/points/pcd.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "tools/base/formats/points/lzf.hpp"
#include "tools/base/formats/points/pcd_header.hpp"

namespace castaway::testbed {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// Where the numbers of one axis are in binary data.
struct PcdColumn {
  ScalarType type{};
  std::size_t start = 0;   ///< [byte] Of the first point.
  std::size_t stride = 0;  ///< [byte] From point to point.
};
using PcdColumns = std::array<PcdColumn, 3>;

std::size_t field_size(const PcdField& field) { return field.type.size * field.count; }

std::size_t point_size(const std::vector<PcdField>& fields) {
  std::size_t size = 0;
  for (const PcdField& field : fields) size += field_size(field);
  return size;
}

/// Columns of data where point follows point.
PcdColumns columns_by_point(const std::vector<PcdField>& fields) {
  PcdColumns columns;
  std::size_t start = 0;
  for (const PcdField& field : fields) {
    const int axis = axis_of(field.name);
    if (axis >= 0)
      columns.at(static_cast<std::size_t>(axis)) = {field.type, start, point_size(fields)};
    start += field_size(field);
  }
  return columns;
}

/// Columns of data where field follows field, each with all points.
PcdColumns columns_by_field(const std::vector<PcdField>& fields, std::size_t points) {
  PcdColumns columns;
  std::size_t start = 0;
  for (const PcdField& field : fields) {
    const int axis = axis_of(field.name);
    if (axis >= 0)
      columns.at(static_cast<std::size_t>(axis)) = {field.type, start, field.type.size};
    start += field_size(field) * points;
  }
  return columns;
}

Points gather(std::string_view data, const PcdColumns& columns, std::size_t points) {
  Points cloud(points);
  for (std::size_t i = 0; i < points; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const PcdColumn& column = columns.at(static_cast<std::size_t>(axis));
      cloud[i][axis] = scalar_at(data.substr(column.start + i * column.stride), column.type,
                                 std::endian::little);
    }
  }
  return cloud;
}

Points read_binary_points(const PcdHeader& header, CloudInput& input) {
  const std::string_view data = input.take(header.points, point_size(header.fields));
  return gather(data, columns_by_point(header.fields), header.points);
}

/// The fields of compressed data of `size` bytes: the Point Cloud Library leaves padding out, other
/// writers keep it.
std::vector<PcdField> compressed_fields(const PcdHeader& header, std::size_t size,
                                        const CloudInput& input) {
  const auto fits = [&](const std::vector<PcdField>& fields) {
    const std::size_t point = point_size(fields);
    return size / point == header.points && size % point == 0;
  };
  std::vector<PcdField> fields = header.fields;
  if (fits(fields)) return fields;
  std::erase_if(fields, [](const PcdField& field) { return field.name == "_"; });
  if (fits(fields)) return fields;
  input.fail(
      fmt::format("{} bytes are compressed, but its header states {} points of {} bytes; "
                  "copy the file again",
                  size, header.points, point_size(fields)));
}

Points read_compressed_points(const PcdHeader& header, CloudInput& input) {
  const ScalarType number{ScalarKind::kUnsigned, 4};
  const auto take_size = [&] {
    return static_cast<std::size_t>(
        scalar_at(input.take(1, number.size), number, std::endian::little));
  };
  const std::size_t packed_size = take_size();
  const std::size_t size = take_size();
  const std::vector<PcdField> fields = compressed_fields(header, size, input);
  const auto data = decompress_lzf(input.take(packed_size, 1), size);
  if (!data) input.fail("its compressed data are damaged; copy the file again");
  return gather(*data, columns_by_field(fields, header.points), header.points);
}

Eigen::Vector3d read_text_point(const std::vector<PcdField>& fields, CloudInput& input) {
  CloudWords words(input.line());
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (const PcdField& field : fields) {
    std::string_view word;
    for (std::uint64_t i = 0; i < field.count; ++i) {
      word = words.next();
      if (word.empty()) input.fail_in_line("fewer values than FIELDS and COUNT state; add them");
    }
    const int axis = axis_of(field.name);
    if (axis < 0) continue;
    const std::optional<double> value = parse_scalar(word);
    if (!value) {
      input.fail_in_line(fmt::format("{} is {}; write a number", field.name, quote_word(word)));
    }
    point[axis] = *value;
  }
  if (!words.next().empty()) {
    input.fail_in_line("more values than FIELDS and COUNT state; correct the header");
  }
  return point;
}

Points read_text_points(const PcdHeader& header, CloudInput& input) {
  std::uint64_t words = 0;
  for (const PcdField& field : header.fields) words += field.count;
  input.require(header.points, 2 * words - 1);
  Points cloud;
  cloud.reserve(header.points);
  for (std::uint64_t i = 0; i < header.points; ++i) {
    cloud.push_back(read_text_point(header.fields, input));
  }
  return cloud;
}

}  // namespace

std::vector<Eigen::Vector3d> decode_pcd(std::string_view bytes, const std::string& name) {
  CloudInput input(bytes, name);
  const PcdHeader header = read_pcd_header(input);
  if (header.points == 0) return {};
  if (header.data == PcdData::kAscii) return read_text_points(header, input);
  if (header.data == PcdData::kBinary) return read_binary_points(header, input);
  return read_compressed_points(header, input);
}

}  // namespace castaway::testbed
