/// A localizer that cannot go on.
#pragma once

#include <stdexcept>

namespace castaway::testbed {

/// Thrown by a localizer that is not castaway's own: the run goes on without it. The text says what
/// it did, e.g. "exited with 1".
class LocalizerFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace castaway::testbed
