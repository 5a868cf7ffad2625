/// Keeps a second thread out of an object whose calls release the GIL.
#pragma once

#include <atomic>
#include <stdexcept>

namespace castaway::python {

/// In use by at most one call at a time.
class OneThread {
 public:
  /// A call; the destructor ends it.
  class Use {
   public:
    /// Throws std::runtime_error if another thread is in a call.
    explicit Use(OneThread& object) : in_use_(object.in_use_) {
      if (in_use_.exchange(true)) {
        throw std::runtime_error("two threads use one object at once; give each thread its own");
      }
    }
    ~Use() { in_use_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    std::atomic<bool>& in_use_;
  };

 private:
  std::atomic<bool> in_use_{false};
};

}  // namespace castaway::python
