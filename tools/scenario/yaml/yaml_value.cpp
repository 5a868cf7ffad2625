#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

using Kind = YamlNode::Kind;

constexpr double kLargest = 1e9;  // Bound of any length, time or rate.

std::string value_text(const YamlNode& node) {
  switch (node.kind) {
    case Kind::kNull:
      return "nothing";
    case Kind::kList:
      return "a list";
    case Kind::kMap:
      return "a map";
    case Kind::kScalar:
      break;
  }
  return "'" + node.scalar + "'";
}

[[noreturn]] void wrong_type(const YamlNode& node, const std::string& path,
                             const std::string& wanted) {
  throw std::runtime_error(
      fmt::format("{}: {}: expected {}, found {}", node.where, path, wanted, value_text(node)));
}

template <typename T>
T number(const YamlNode& node, const std::string& path, const std::string& wanted) {
  if (node.kind != Kind::kScalar) wrong_type(node, path, wanted);
  const char* begin = node.scalar.data();
  const char* end = begin + node.scalar.size();
  if (begin != end && *begin == '+') ++begin;
  T value{};
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end) wrong_type(node, path, wanted);
  return value;
}

template <typename T>
std::vector<T> list_of(const YamlNode& node, const std::string& path, const std::string& wanted) {
  if (node.kind != Kind::kList) wrong_type(node, path, wanted);
  std::vector<T> values;
  for (const YamlNode& item : node.items) {
    values.push_back(read_yaml<T>(item, fmt::format("{}[{}]", path, values.size())));
  }
  return values;
}

template <int N>
Eigen::Matrix<double, N, 1> vector_of(const YamlNode& node, const std::string& path) {
  const std::string wanted = fmt::format("a list of {} numbers", N);
  const std::vector<double> values = list_of<double>(node, path, wanted);
  if (values.size() != N) {
    throw std::runtime_error(fmt::format("{}: {}: expected {}, found {} of them", node.where, path,
                                         wanted, values.size()));
  }
  return Eigen::Matrix<double, N, 1>(values.data());
}

template <typename Range>
YamlNode node_list(const Range& values) {
  YamlNode node;
  node.kind = Kind::kList;
  for (const auto& value : values) node.items.push_back(write_yaml(value));
  return node;
}

}  // namespace

template <>
bool read_yaml<bool>(const YamlNode& node, const std::string& path) {
  if (node.kind == Kind::kScalar && node.scalar == "true") return true;
  if (node.kind == Kind::kScalar && node.scalar == "false") return false;
  wrong_type(node, path, "true or false");
}

template <>
int read_yaml<int>(const YamlNode& node, const std::string& path) {
  return number<int>(node, path, "a whole number");
}

template <>
std::uint64_t read_yaml<std::uint64_t>(const YamlNode& node, const std::string& path) {
  return number<std::uint64_t>(node, path, "a whole number from 0");
}

template <>
double read_yaml<double>(const YamlNode& node, const std::string& path) {
  const double value = number<double>(node, path, "a number");
  if (!(std::abs(value) <= kLargest))
    wrong_type(node, path, "a finite number of at most 1e9 either way");
  return value;
}

template <>
std::string read_yaml<std::string>(const YamlNode& node, const std::string& path) {
  if (node.kind != Kind::kScalar) wrong_type(node, path, "a text");
  return node.scalar;
}

template <>
std::vector<double> read_yaml<std::vector<double>>(const YamlNode& node, const std::string& path) {
  return list_of<double>(node, path, "a list of numbers");
}

template <>
std::vector<std::string> read_yaml<std::vector<std::string>>(const YamlNode& node,
                                                             const std::string& path) {
  return list_of<std::string>(node, path, "a list of texts");
}

template <>
Eigen::Vector2d read_yaml<Eigen::Vector2d>(const YamlNode& node, const std::string& path) {
  return vector_of<2>(node, path);
}

template <>
Eigen::Vector3d read_yaml<Eigen::Vector3d>(const YamlNode& node, const std::string& path) {
  return vector_of<3>(node, path);
}

YamlNode write_yaml(bool value) { return yaml_scalar(value ? "true" : "false"); }
YamlNode write_yaml(int value) { return yaml_scalar(fmt::format("{}", value)); }
YamlNode write_yaml(std::uint64_t value) { return yaml_scalar(fmt::format("{}", value)); }
YamlNode write_yaml(double value) { return yaml_scalar(fmt::format("{}", value)); }
YamlNode write_yaml(const std::string& value) { return yaml_scalar(value); }
YamlNode write_yaml(const std::vector<double>& value) { return node_list(value); }
YamlNode write_yaml(const std::vector<std::string>& value) { return node_list(value); }
YamlNode write_yaml(const Eigen::Vector2d& value) { return node_list(value); }
YamlNode write_yaml(const Eigen::Vector3d& value) { return node_list(value); }

}  // namespace castaway::testbed
