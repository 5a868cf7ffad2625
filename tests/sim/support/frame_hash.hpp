/// Hash of what a simulated run delivers.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <variant>
#include <vector>

#include "sim/stages/sim_frame.hpp"

namespace castaway::sim {

/// FNV-1a hash of all numbers of a run.
class Hash {
 public:
  template <typename T>
  void add(const T& value) {
    std::array<unsigned char, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(T));
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 1099511628211ULL;
  }
  void add(const Pose2& pose) {
    add(pose.x);
    add(pose.y);
    add(pose.yaw);
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

inline void add_data(const KidnapRecord& r, Hash& hash) { hash.add(r.T_map_to); }
inline void add_data(const OdometryReading& r, Hash& hash) {
  hash.add(r.T_odom_base);
  hash.add(r.T_map_base_true);
}
inline void add_data(const HappeningRecord& r, Hash& hash) {
  hash.add(r.what.index());
  hash.add(r.T_map_base);
}
inline void add_data(const ImuReading& r, Hash& hash) {
  for (const double value : r.angular_velocity) hash.add(value);
  for (const double value : r.linear_acceleration) hash.add(value);
}
inline void add_data(const LidarReading& r, Hash& hash) {
  for (const float range : r.ranges) hash.add(range);
  for (const int object : r.hit_object) hash.add(object);
}

inline std::uint64_t hash_of(const std::vector<SimFrame>& frames) {
  Hash hash;
  for (const SimFrame& frame : frames) {
    hash.add(frame.stamp.count());
    std::visit([&hash](const auto& data) { add_data(data, hash); }, frame.data);
  }
  return hash.value();
}

}  // namespace castaway::sim
