#include "tools/base/formats/junit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/base/bytes/utf8.hpp"

namespace castaway::testbed {
namespace {

/// Escapes text for XML content and attributes. XML 1.0 cannot represent control characters.
std::string escape_xml(const std::string& text) {
  std::string result;
  for (const char c : valid_utf8(text)) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\n' || c == '\t')
      result += ' ';
    else if (static_cast<unsigned char>(c) >= 0x20)
      result += c;
  }
  return result;
}

std::string outcome(const char* element, const char* type, const std::string& text) {
  return fmt::format("      <{0} message=\"{2}\" type=\"{1}\">{2}</{0}>\n", element, type,
                     escape_xml(text));
}

std::string case_xml(const JunitCase& test) {
  const std::string head =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"",
                  escape_xml(test.class_name), escape_xml(test.name), test.time_s);
  if (test.error) return head + ">\n" + outcome("error", "run", *test.error) + "    </testcase>\n";
  if (test.failure) {
    return head + ">\n" + outcome("failure", "expectation", *test.failure) + "    </testcase>\n";
  }
  return head + "/>\n";
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::vector<JunitCase>& cases) {
  double time_s = 0.0;
  for (const JunitCase& test : cases) time_s += test.time_s;
  const auto errors =
      std::count_if(cases.begin(), cases.end(), [](const auto& test) { return test.error; });
  const auto failures = std::count_if(cases.begin(), cases.end(),
                                      [](const auto& test) { return test.failure && !test.error; });
  const std::string counts =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", cases.size(),
                  failures, errors, time_s);
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"castaway\" {0}>\n"
      "  <testsuite name=\"{1}\" {0} skipped=\"0\">\n",
      counts, escape_xml(suite));
  for (const JunitCase& test : cases) xml += case_xml(test);
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace castaway::testbed
