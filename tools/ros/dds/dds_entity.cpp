#include "tools/ros/dds/dds_entity.hpp"

#include <stdexcept>

#include <dds/dds.h>

namespace castaway::testbed {

DdsEntity::DdsEntity(std::int32_t handle, const std::string& what) : handle_(handle) {
  require_dds(handle, what);
}

DdsEntity::~DdsEntity() {
  if (handle_ > 0) dds_delete(handle_);
}

void require_dds(std::int32_t code, const std::string& what) {
  if (code < 0) throw std::runtime_error("cannot " + what + ": " + dds_strretcode(code));
}

}  // namespace castaway::testbed
