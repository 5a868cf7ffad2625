/// Events of a run.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include <Eigen/Core>

#include "castaway/pose.hpp"
#include "sim/record/happening.hpp"
#include "tools/run/localizer_order.hpp"

namespace castaway::testbed {

using sim::OrText;

/// The robot was moved without odometry.
struct KidnapEvent {
  /// A recorded log goes on elsewhere.
  struct Splice {
    bool operator==(const Splice&) const = default;
  };

  using How = OrText<sim::KidnapKind, Splice>;
  How how;
  /// [m] In a run on several floors: the ground before and after.
  std::optional<Eigen::Vector2d> heights{};
};

/// The run is void: it is not scored.
struct VoidEvent {
  using Reason = OrText<sim::VoidReason>;
  Reason reason;
};

/// A localizer reports that it is lost, or no longer so.
struct AlarmEvent {
  bool on = true;
  std::string localizer{};
};

/// A localizer is right again.
struct RecoveryEvent {
  enum class From { kStart, kKidnap };

  OrText<From> from;
  std::string localizer{};
};

/// A remark for the reader of the run.
struct WarningEvent {
  std::string sentence;
};

/// An operator restarted a localizer, or switched it off or on.
struct OperatorEvent {
  OrText<LocalizerOrder::What> order;
  std::string localizer{};
};

/// A localizer failed; the run goes on without it.
struct FailureEvent {
  std::string reason;  ///< "ended: exit code 3"
  std::string localizer{};
};

/// A node of ROS 2 came, went or was not understood.
struct NodeEvent {
  std::string sentence;
  std::string localizer{};
};

/// A localizer starts anywhere on the map.
struct UnknownStart {
  bool operator==(const UnknownStart&) const = default;
};

/// A localizer starts anew by an operator's order.
struct OrderedStart {
  bool operator==(const OrderedStart&) const = default;
};

/// What a localizer has to recover from.
using LossCause = std::variant<UnknownStart, KidnapEvent::How, OrderedStart>;

/// The alternatives of a variant, and more.
template <typename Variant, typename... More>
struct Joined;
template <typename... T, typename... More>
struct Joined<std::variant<T...>, More...> {
  using Type = std::variant<More..., T...>;
};

/// All sorts of events. What happens in the simulator keeps its types.
using EventData = Joined<sim::Happening, KidnapEvent, VoidEvent, AlarmEvent, RecoveryEvent,
                         WarningEvent, OperatorEvent, FailureEvent, NodeEvent>::Type;

/// Something that happened in a run. Localizers do not see it.
struct RunEvent {
  localization::Stamp stamp{};
  EventData what{};
  std::optional<localization::SE2> T_map_from{};  ///< True pose of base before.
  std::optional<localization::SE2> T_map_to{};    ///< True pose of base after.
  std::optional<localization::Stamp> since{};     ///< Its beginning; nothing: instantaneous.

  /// Its beginning.
  [[nodiscard]] localization::Stamp begun() const { return since.value_or(stamp); }
  template <typename Sort>
  [[nodiscard]] bool is() const {
    return std::holds_alternative<Sort>(what);
  }
  /// nullptr: it is of another sort.
  template <typename Sort>
  [[nodiscard]] const Sort* as() const {
    return std::get_if<Sort>(&what);
  }
};

/// The localizer that an event is about; empty: it is about the run.
std::string localizer_of(const EventData& what);

/// The object or door of the world that has changed; empty: none.
std::string object_of(const sim::WorldNews& news);

}  // namespace castaway::testbed
