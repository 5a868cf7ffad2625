#include "tools/batch/jobs/row_line.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// The field of a line that comes last: its check sum over all before it.
constexpr std::string_view kSum = ",\"sum\":\"";
constexpr std::size_t kDigits = 16;

std::string with_sum(const std::string& fields) {
  return fields + std::string(kSum) + sha256(fields).substr(0, kDigits) + "\"}";
}

/// Throws std::runtime_error if the line is not as it was written.
void require_sum(const std::string& line) {
  const std::size_t sum = line.rfind(kSum);
  if (sum != std::string::npos && with_sum(line.substr(0, sum)) == line) return;
  throw std::runtime_error(
      "is no row as castaway wrote it; remove the line, and the same command makes it again");
}

/// Calls `read` with the fields of a line.
template <class Read>
auto read_row(const std::string& line, const Read& read) {
  const Json fields = parse_row_line(line);
  try {
    return read(fields);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("is no row: ") + error.what());
  }
}

std::string text_of(const std::string& line, const char* name) {
  return read_row(line, [name](const Json& row) { return row.at(name).get<std::string>(); });
}

}  // namespace

std::string row_line(const Json& fields) {
  std::string text = json_text(fields);
  text.pop_back();  // The brace.
  return with_sum(text);
}

Json parse_row_line(const std::string& line) {
  require_sum(line);
  try {
    return Json::parse(line);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("is no row: ") + error.what());
  }
}

RowHead head_of(const std::string& line) {
  return read_row(line, [](const Json& row) {
    return RowHead{row.at("index").get<int>(), row.at("state").get<std::string>() == "failed"};
  });
}

std::string failed_row_line(int job, const std::string& reason) {
  std::string one_line = reason;
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  return row_line({{"index", job}, {"state", "failed"}, {"reason", one_line}});
}

std::string done_row_line(int job, const std::string& result) {
  return row_line({{"index", job}, {"state", "done"}, {"result", result}});
}

std::string result_of_row(const std::string& line) { return text_of(line, "result"); }

std::string reason_of_row(const std::string& line) { return text_of(line, "reason"); }

}  // namespace castaway::testbed
