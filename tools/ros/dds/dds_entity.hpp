/// What CycloneDDS gives out: handles, which end with their objects, and errors.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace castaway::testbed {

/// Owns a domain, participant, reader, writer... of CycloneDDS.
class DdsEntity {
 public:
  /// Throws std::runtime_error "cannot <what>: <why>" if `handle` is an error code.
  DdsEntity(std::int32_t handle, const std::string& what);
  ~DdsEntity();
  DdsEntity(DdsEntity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  DdsEntity& operator=(DdsEntity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }

  [[nodiscard]] std::int32_t handle() const { return handle_; }

 private:
  std::int32_t handle_;
};

/// The same error for a call that returns a code.
void require_dds(std::int32_t code, const std::string& what);

}  // namespace castaway::testbed
