#include "tools/run/event_names.hpp"

#include <set>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using sim::WorldNews;

/// An event, and its names in files.
struct NamedEvent {
  EventData what;
  std::string kind;
  std::string detail;
};

std::vector<NamedEvent> named_events() {
  using Fault = sim::SensorFault;
  using Order = LocalizerOrder::What;
  const Fault front{sim::FaultKind::kLidarDropout, "front left"};
  const Fault reset{sim::FaultKind::kOdometryReset, ""};
  return {
      {KidnapEvent{sim::KidnapKind::kTeleportRandom}, "kidnap", "teleport"},
      {KidnapEvent{sim::KidnapKind::kTeleportTo}, "kidnap", "teleport_to"},
      {KidnapEvent{sim::KidnapKind::kLookAlike}, "kidnap", "look_alike"},
      {KidnapEvent{sim::KidnapKind::kNudge}, "kidnap", "nudge"},
      {KidnapEvent{sim::KidnapKind::kTurn}, "kidnap", "turn"},
      {KidnapEvent{sim::KidnapKind::kCarry}, "kidnap", "carry"},
      {KidnapEvent{sim::KidnapKind::kSpin}, "kidnap", "spin"},
      {KidnapEvent{sim::KidnapKind::kElevator}, "kidnap", "elevator"},
      {KidnapEvent{sim::KidnapKind::kPalletTruck}, "kidnap", "pallet_truck"},
      {KidnapEvent{KidnapEvent::Splice{}}, "kidnap", "splice"},
      {sim::PickUp{sim::KidnapKind::kElevator}, "pick-up", "elevator"},
      {sim::Collision{}, "collision", ""},
      {sim::Collision{sim::Collision::Person{3}}, "collision", "person 3"},
      {sim::FaultEdge{front, true}, "fault on", "lidar-dropout front left"},
      {sim::FaultEdge{reset, false}, "fault off", "odometry-reset"},
      {sim::Driving{sim::Recovery::kWait}, "driving", "wait"},
      {sim::Driving{sim::Recovery::kReplan}, "driving", "re-plan"},
      {sim::Driving{sim::Recovery::kBackUp}, "driving", "back up"},
      {sim::Driving{sim::Recovery::kSpin}, "driving", "spin"},
      {sim::Driving{sim::Driving::Stop{}}, "driving", "emergency stop"},
      {WorldNews{WorldNews::Put{"box-1"}}, "world", "box-1 put"},
      {WorldNews{WorldNews::Take{"box-1"}}, "world", "box-1 taken away"},
      {WorldNews{WorldNews::Door{"D1", 0.0}}, "world", "D1 closed"},
      {WorldNews{WorldNews::Door{"D1", -62.5}}, "world", "D1 open by -62.5 deg"},
      {WorldNews{WorldNews::People{1}}, "world", "a person came"},
      {WorldNews{WorldNews::People{3}}, "world", "3 people came"},
      {VoidEvent{sim::VoidReason::kContactFromStart}, "void", "contact_from_start"},
      {VoidEvent{sim::VoidReason::kNeverMoved}, "void", "never_moved"},
      {VoidEvent{sim::VoidReason::kStuck}, "void", "stuck"},
      {AlarmEvent{true}, "alarm on", ""},
      {AlarmEvent{false}, "alarm off", ""},
      {RecoveryEvent{RecoveryEvent::From::kStart}, "recovery", "from unknown start"},
      {RecoveryEvent{RecoveryEvent::From::kKidnap}, "recovery", "from kidnap"},
      {WarningEvent{"no free place"}, "warning", "no free place"},
      {OperatorEvent{Order::kInitialize}, "operator", "initialize"},
      {OperatorEvent{Order::kRelocalize}, "operator", "relocalize"},
      {OperatorEvent{Order::kOff}, "operator", "off"},
      {OperatorEvent{Order::kOn}, "operator", "on"},
      {FailureEvent{"ended: exit code 3"}, "localizer failed", "ended: exit code 3"},
      {NodeEvent{"amcl is there"}, "node", "amcl is there"},
  };
}

/// Calls `visit` with the part of an event that is one of several values or a text.
template <typename Visit>
void visit_part(const EventData& what, Visit visit) {
  if (const auto* kidnap = std::get_if<KidnapEvent>(&what)) visit(kidnap->how);
  if (const auto* pick_up = std::get_if<sim::PickUp>(&what)) visit(pick_up->by);
  if (const auto* collision = std::get_if<sim::Collision>(&what)) visit(collision->with);
  if (const auto* fault = std::get_if<sim::FaultEdge>(&what)) visit(fault->what);
  if (const auto* driving = std::get_if<sim::Driving>(&what)) visit(driving->what);
  if (const auto* news = std::get_if<WorldNews>(&what)) visit(news->what);
  if (const auto* run = std::get_if<VoidEvent>(&what)) visit(run->reason);
  if (const auto* recovery = std::get_if<RecoveryEvent>(&what)) visit(recovery->from);
  if (const auto* order = std::get_if<OperatorEvent>(&what)) visit(order->order);
}

/// True if an event has a text where others have a value.
bool has_text(const EventData& what) {
  bool text = false;
  visit_part(what, [&](const auto& part) { text = std::holds_alternative<std::string>(part); });
  return text;
}

bool is_same(const EventData& a, const EventData& b) {
  bool same = a.index() == b.index();
  visit_part(a, [&]<typename Part>(const Part& part) {
    visit_part(b, [&]<typename Other>(const Other& other) {
      if constexpr (std::is_same_v<Part, Other>) same = same && part == other;
    });
  });
  return same;
}

TEST(EventNames, AreThoseOfTheFiles) {
  for (const NamedEvent& event : named_events()) {
    const EventNames names = names_of(event.what);
    EXPECT_EQ(names.kind, event.kind) << event.detail;
    EXPECT_EQ(names.detail, event.detail) << event.kind;
  }
}

TEST(EventNames, OfEverySortAreReadBack) {
  std::set<std::size_t> sorts;
  for (const NamedEvent& event : named_events()) {
    const auto read = event_named(event.kind, event.detail);
    ASSERT_TRUE(read) << event.kind;
    EXPECT_TRUE(is_same(*read, event.what)) << event.kind << ": " << event.detail;
    EXPECT_FALSE(has_text(*read)) << event.kind << ": " << event.detail;
    sorts.insert(read->index());
  }
  EXPECT_EQ(sorts.size(), std::variant_size_v<EventData>);
  EXPECT_EQ(std::get<AlarmEvent>(*event_named("alarm off", "")).on, false);
  EXPECT_EQ(std::get<sim::FaultEdge>(*event_named("fault off", "lidar-late")).begins, false);
}

TEST(EventNames, ADetailThatIsNotKnownStaysAsItIs) {
  const std::vector<std::pair<std::string, std::string>> unknown{{"kidnap", ""},
                                                                 {"kidnap", "by a crane"},
                                                                 {"pick-up", "by a crane"},
                                                                 {"collision", "wall"},
                                                                 {"collision", "person 03"},
                                                                 {"collision", "person x"},
                                                                 {"fault on", "sonar"},
                                                                 {"fault off", "lidar-late "},
                                                                 {"driving", "dance"},
                                                                 {"world", "rain"},
                                                                 {"world", "02 people came"},
                                                                 {"world", "D1 open by 090 deg"},
                                                                 {"world", "D open deg"},
                                                                 {"void", "bored"},
                                                                 {"recovery", "by luck"},
                                                                 {"operator", "shut down"}};
  for (const auto& [kind, detail] : unknown) {
    const auto read = event_named(kind, detail);
    ASSERT_TRUE(read) << kind;
    EXPECT_TRUE(has_text(*read)) << kind << ": " << detail;
    EXPECT_EQ(names_of(*read).kind, kind);
    EXPECT_EQ(names_of(*read).detail, detail);
  }
}

TEST(EventNames, ASortThatIsNotKnownIsNone) {
  EXPECT_FALSE(event_named("kidnapped", "teleport"));
  EXPECT_FALSE(event_named("", ""));
}

TEST(EventNames, NameWhatALocalizerHasToRecoverFrom) {
  for (const std::string name : {"start", "operator", "teleport", "splice", "by a crane"}) {
    EXPECT_EQ(part_name(cause_named(name)), name);
  }
  EXPECT_TRUE(std::holds_alternative<UnknownStart>(cause_named("start")));
  EXPECT_TRUE(std::holds_alternative<OrderedStart>(cause_named("operator")));
  EXPECT_EQ(cause_named("carry"), LossCause(KidnapEvent::How(sim::KidnapKind::kCarry)));
}

}  // namespace
}  // namespace castaway::testbed
