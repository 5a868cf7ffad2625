/// Exit codes of the program.
#pragma once

namespace castaway::testbed {

enum ExitCode : int {
  kDone = 0,
  kRunFailed = 1,
  kBadInput = 2,
  kExpectationNotMet = 3,
};

}  // namespace castaway::testbed
