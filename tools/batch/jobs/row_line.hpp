/// What is kept of a job: a line of JSON with a check sum.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace castaway::testbed {

/// The line of `fields`, an object with `index` (of the job) and `state`. Without a line feed; its
/// last field is a check sum over the others.
std::string row_line(const nlohmann::ordered_json& fields);

/// What every line says.
struct RowHead {
  int job = 0;
  bool failed = false;
};

/// The head of a line. Throws std::runtime_error as `parse_row_line` does.
RowHead head_of(const std::string& line);

/// The fields of a line. Throws std::runtime_error if it is none, or was changed since.
nlohmann::ordered_json parse_row_line(const std::string& line);

/// The row of a job that failed, or whose process was lost: `reason` is one line.
std::string failed_row_line(int job, const std::string& reason);

/// The row of a job that is done; `result`: JSON.
std::string done_row_line(int job, const std::string& result);

/// The result in a line of `done_row_line`. Throws std::runtime_error if there is none.
std::string result_of_row(const std::string& line);

/// Why the job of a line of `failed_row_line` failed.
std::string reason_of_row(const std::string& line);

}  // namespace castaway::testbed
