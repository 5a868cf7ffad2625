/// Test results as JUnit XML, as GitHub, GitLab and Jenkins read it.
///
/// There is no standard; this keeps to what the schema of Jenkins' xUnit plug-in (junit-10.xsd)
/// allows and the readers agree on: testsuites, testsuite, testcase, failure, error.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace castaway::testbed {

/// One case.
struct JunitCase {
  std::string class_name;  ///< Groups cases: dots are levels.
  std::string name;
  double time_s = 0.0;                 ///< [s]
  std::optional<std::string> failure;  ///< What was not met, one line; nothing: it passed.
  std::optional<std::string> error;    ///< Why it could not be judged, one line.
};

/// The document with one suite. Characters that XML does not allow are left out.
std::string junit_xml(const std::string& suite, const std::vector<JunitCase>& cases);

}  // namespace castaway::testbed
