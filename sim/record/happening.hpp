/// What happens in a world, as plain data: from where it happens to the last line before a file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace castaway::sim {

/// One of several values, or what a file says for which there is no value. Only its readers make
/// such texts, and nothing is decided by them.
template <typename... T>
using OrText = std::variant<T..., std::string>;

/// Kinds of kidnaps.
enum class KidnapKind : std::uint8_t {
  kTeleportRandom,  ///< To a random pose in reachable free space, far enough away.
  kTeleportTo,      ///< To a given pose.
  kLookAlike,  ///< To the pose, far enough away, whose scan is most similar to the current one.
  kNudge,      ///< Pushed through free space a little; heading changes by at most 0.3 rad.
  kTurn,       ///< Turned in place, to either side.
  kCarry,      ///< Lifted, carried through free space to a given or a random pose, and put down.
  kSpin,       ///< Lifted while its wheels keep turning, and put down where it was.
  /// Take to another level by a lift whose doors are closed: the lidars see nothing.
  kElevator,
  kPalletTruck,  ///< As kCarry, close to the floor and over ramps; the lidars see.
};

/// Kinds of sensor faults.
enum class FaultKind : std::uint8_t {
  kLidarDropout,      ///< No scans arrive.
  kLidarFrozen,       ///< The last scan is repeated with new stamps.
  kLidarBlocked,      ///< Something near covers a sector.
  kLidarMount,        ///< The reported mount of the lidar is wrong.
  kLidarLate,         ///< Scans are delivered late.
  kLidarClock,        ///< Scans are stamped by a clock with an offset.
  kOdometryFrozen,    ///< Readings do not change; motion during the fault is lost.
  kOdometryScale,     ///< Encoders count too much or too little.
  kOdometryReversed,  ///< The encoder of one wheel counts backwards.
  kOdometryDropout,   ///< No readings arrive; the next one contains the motion meanwhile.
  kOdometryReset,     ///< A power cycle: odometry starts from zero.
};

/// Names of the kinds, in their order: in scenarios, their errors and files.
inline constexpr std::array<const char*, 11> kFaultNames = {
    "lidar-dropout",     "lidar-frozen",     "lidar-blocked",   "lidar-mount",
    "lidar-late",        "lidar-clock",      "odometry-frozen", "odometry-scale",
    "odometry-reversed", "odometry-dropout", "odometry-reset"};

/// The name of a kind, as in `kFaultNames`.
constexpr const char* to_string(FaultKind kind) {
  return kFaultNames[static_cast<std::size_t>(kind)];
}

/// Recovery behaviours of the driver, in the order in which they are tried.
enum class Recovery : std::uint8_t {
  kWait,    ///< Stands still: what is in the way may go.
  kReplan,  ///< Plans around the obstacles that the lidars see.
  kBackUp,  ///< Drives back a little.
  kSpin,    ///< Turns by 90 degrees to the side with more room.
};

/// Why a run is void.
enum class VoidReason : std::uint8_t {
  kContactFromStart,  ///< The robot touches an obstacle from the first second on.
  kNeverMoved,        ///< The robot was to drive and never moved.
  kStuck,  ///< The robot was to drive and got stuck until the end, or for most of the run.
};

/// The robot touched a person, or anything else but the floor.
struct Collision {
  struct Anything {
    bool operator==(const Anything&) const = default;
  };
  struct Person {
    int number = 0;
    bool operator==(const Person&) const = default;
  };

  using With = OrText<Anything, Person>;
  With with;
};

/// A fault of a sensor.
struct SensorFault {
  FaultKind kind = FaultKind::kLidarDropout;
  std::string lidar{};  ///< Empty: all lidars, or odometry.
  bool operator==(const SensorFault&) const = default;
};

/// A fault of a sensor begins or ends.
struct FaultEdge {
  using What = OrText<SensorFault>;
  What what;
  bool begins = true;
};

/// The robot was lifted from the floor. A kidnap follows when it stands again.
struct PickUp {
  OrText<KidnapKind> by = KidnapKind::kCarry;  ///< The kidnap that begins with it.
};

/// The driver began a recovery behaviour or an emergency stop.
struct Driving {
  struct Stop {
    bool operator==(const Stop&) const = default;
  };

  using What = OrText<Recovery, Stop>;
  What what;
  bool operator==(const Driving&) const = default;
};

/// The world changed.
struct WorldNews {
  struct Put {
    std::string name;  ///< Of the object.
    bool operator==(const Put&) const = default;
  };
  struct Take {
    std::string name;  ///< Of the object.
    bool operator==(const Take&) const = default;
  };
  struct Door {
    std::string name;
    double open_deg = 0.0;  ///< [deg] 0: closed.
    bool operator==(const Door&) const = default;
  };
  struct People {
    int count = 1;
    bool operator==(const People&) const = default;
  };

  using What = OrText<Put, Take, Door, People>;
  What what;
  std::vector<Eigen::Vector2d> outline{};  ///< [m] Of what stands there now, in map; may be empty.
  Eigen::Vector2d z{0.0, 0.0};             ///< [m] Its lower and its upper end.
};

/// What may happen besides a kidnap. At the same time they are delivered in this order.
using Happening = std::variant<Collision, FaultEdge, PickUp, Driving, WorldNews>;

}  // namespace castaway::sim
