/// Makes outputs one by one, so that the failure of one leaves the others.
#pragma once

#include <exception>

namespace castaway::testbed {

/// Keeps the first failure of what it is given.
class Attempts {
 public:
  /// Calls `make`. False if it threw a std::exception.
  template <typename Make>
  bool make(Make&& make) {
    try {
      make();
      return true;
    } catch (const std::exception&) {
      if (!first_) first_ = std::current_exception();
      return false;
    }
  }
  [[nodiscard]] bool failed() const { return first_ != nullptr; }
  /// Throws the first failure, if there was one.
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::exception_ptr first_;
};

}  // namespace castaway::testbed
