/// Writes test results as JUnit XML, as read by GitHub, GitLab and Jenkins.
///
/// There is no standard. This writes only what the schema of Jenkins' xUnit plug-in (junit-10.xsd)
/// allows and all readers understand: testsuites, testsuite, testcase, failure, error.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace castaway::testbed {

/// One test case.
struct JunitCase {
  std::string class_name;  ///< Groups cases; dots separate levels.
  std::string name;
  double time_s = 0.0;                 ///< [s]
  std::optional<std::string> failure;  ///< The unmet expectation, one line; nothing if the case
                                       ///< passed.
  std::optional<std::string> error;    ///< Why the case could not be evaluated, one line.
};

/// The document with one suite. Characters that XML does not allow are dropped.
std::string junit_xml(const std::string& suite, const std::vector<JunitCase>& cases);

}  // namespace castaway::testbed
