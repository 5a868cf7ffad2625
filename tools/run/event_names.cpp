#include "tools/run/event_names.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

using sim::WorldNews;

/// Names of the values of an enumeration, in their order.
template <std::size_t size>
using Names = std::array<const char*, size>;

constexpr Names<9> kKidnapNames = {"teleport", "teleport_to", "look_alike", "nudge",       "turn",
                                   "carry",    "spin",        "elevator",   "pallet_truck"};
constexpr Names<4> kDrivingNames = {"wait", "re-plan", "back up", "spin"};
constexpr Names<3> kVoidNames = {"contact_from_start", "never_moved", "stuck"};
constexpr Names<2> kRecoveryNames = {"from unknown start", "from kidnap"};
constexpr Names<4> kOrderNames = {"initialize", "relocalize", "off", "on"};

constexpr const char* kSplice = "splice";
constexpr const char* kStop = "emergency stop";
constexpr const char* kStart = "start";
constexpr const char* kOrderedStart = "operator";

template <typename Kind, std::size_t size>
std::string name_in(const Names<size>& names, Kind kind) {
  return names.at(static_cast<std::size_t>(kind));
}

/// The value of an enumeration with this name, else the name itself.
template <typename Part, typename Kind, std::size_t size>
Part value_or_text(const Names<size>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return name;
  return static_cast<Kind>(found - names.begin());
}

std::string text_of(const std::string& text) { return text; }
std::string text_of(sim::KidnapKind kind) { return name_in(kKidnapNames, kind); }
std::string text_of(KidnapEvent::Splice) { return kSplice; }
std::string text_of(sim::Recovery recovery) { return name_in(kDrivingNames, recovery); }
std::string text_of(sim::Driving::Stop) { return kStop; }
std::string text_of(sim::VoidReason reason) { return name_in(kVoidNames, reason); }
std::string text_of(RecoveryEvent::From from) { return name_in(kRecoveryNames, from); }
std::string text_of(LocalizerOrder::What order) { return name_in(kOrderNames, order); }
std::string text_of(UnknownStart) { return kStart; }
std::string text_of(OrderedStart) { return kOrderedStart; }
std::string text_of(sim::Collision::Anything) { return ""; }
std::string text_of(const sim::Collision::Person& person) {
  return fmt::format("person {}", person.number);
}
std::string text_of(const sim::SensorFault& fault) {
  const std::string kind = sim::to_string(fault.kind);
  return fault.lidar.empty() ? kind : kind + " " + fault.lidar;
}
std::string text_of(const WorldNews::Put& put) { return put.name + " put"; }
std::string text_of(const WorldNews::Take& take) { return take.name + " taken away"; }
std::string text_of(const WorldNews::Door& door) {
  return door.open_deg == 0.0 ? door.name + " closed"
                              : fmt::format("{} open by {:g} deg", door.name, door.open_deg);
}
std::string text_of(const WorldNews::People& people) {
  return people.count == 1 ? "a person came" : fmt::format("{} people came", people.count);
}

/// Of one of several values.
template <typename... T>
std::string text_of(const std::variant<T...>& part) {
  return std::visit([](const auto& value) { return text_of(value); }, part);
}

/// A value that was read from a text, if it gives the text back; else the text.
template <typename Part>
Part checked(Part value, const std::string& text) {
  return text_of(value) == text ? value : Part(text);
}

/// The text before an end, if it has that end.
std::optional<std::string> before(const std::string& text, const std::string& end) {
  if (!text.ends_with(end)) return std::nullopt;
  return text.substr(0, text.size() - end.size());
}

template <typename Number>
std::optional<Number> whole_number(const std::string& text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && read == end ? std::optional(number) : std::nullopt;
}

KidnapEvent::How kidnap_named(const std::string& name) {
  if (name == kSplice) return KidnapEvent::Splice{};
  return value_or_text<KidnapEvent::How, sim::KidnapKind>(kKidnapNames, name);
}

sim::Collision::With collision_named(const std::string& name) {
  if (name.empty()) return sim::Collision::Anything{};
  const auto number = whole_number<int>(name.substr(std::min(name.size(), name.find(' ') + 1)));
  return checked<sim::Collision::With>(sim::Collision::Person{number.value_or(0)}, name);
}

sim::FaultEdge::What fault_named(const std::string& name) {
  const std::size_t gap = std::min(name.size(), name.find(' '));
  const auto found =
      std::find(sim::kFaultNames.begin(), sim::kFaultNames.end(), name.substr(0, gap));
  if (found == sim::kFaultNames.end()) return name;
  const auto kind = static_cast<sim::FaultKind>(found - sim::kFaultNames.begin());
  const std::string lidar = name.substr(std::min(name.size(), gap + 1));
  return checked<sim::FaultEdge::What>(sim::SensorFault{kind, lidar}, name);
}

sim::Driving::What driving_named(const std::string& name) {
  if (name == kStop) return sim::Driving::Stop{};
  return value_or_text<sim::Driving::What, sim::Recovery>(kDrivingNames, name);
}

WorldNews::What door_named(const std::string& name) {
  if (const auto door = before(name, " closed")) return WorldNews::Door{*door};
  const std::string by = " open by ";
  const auto all = before(name, " deg");
  const std::size_t found = all ? all->rfind(by) : std::string::npos;
  if (found == std::string::npos) return name;
  const auto open_deg = whole_number<double>(all->substr(found + by.size()));
  return checked<WorldNews::What>(WorldNews::Door{name.substr(0, found), open_deg.value_or(0.0)},
                                  name);
}

WorldNews::What news_named(const std::string& name) {
  if (const auto object = before(name, " put")) return WorldNews::Put{*object};
  if (const auto object = before(name, " taken away")) return WorldNews::Take{*object};
  if (name == text_of(WorldNews::People{1})) return WorldNews::People{1};
  if (const auto count = before(name, " people came")) {
    const WorldNews::People people{whole_number<int>(*count).value_or(0)};
    return checked<WorldNews::What>(people, name);
  }
  return door_named(name);
}

EventNames names_of_sort(const KidnapEvent& event) { return {"kidnap", text_of(event.how)}; }
EventNames names_of_sort(const sim::PickUp& event) { return {"pick-up", text_of(event.by)}; }
EventNames names_of_sort(const sim::Collision& event) { return {"collision", text_of(event.with)}; }
EventNames names_of_sort(const sim::FaultEdge& event) {
  return {event.begins ? "fault on" : "fault off", text_of(event.what)};
}
EventNames names_of_sort(const sim::Driving& event) { return {"driving", text_of(event.what)}; }
EventNames names_of_sort(const WorldNews& event) { return {"world", text_of(event.what)}; }
EventNames names_of_sort(const VoidEvent& event) { return {"void", text_of(event.reason)}; }
EventNames names_of_sort(const AlarmEvent& event) {
  return {event.on ? "alarm on" : "alarm off", ""};
}
EventNames names_of_sort(const RecoveryEvent& event) { return {"recovery", text_of(event.from)}; }
EventNames names_of_sort(const WarningEvent& event) { return {"warning", event.sentence}; }
EventNames names_of_sort(const OperatorEvent& event) { return {"operator", text_of(event.order)}; }
EventNames names_of_sort(const FailureEvent& event) { return {"localizer failed", event.reason}; }
EventNames names_of_sort(const NodeEvent& event) { return {"node", event.sentence}; }

/// Reads a sort of events from its detail.
struct SortReader {
  const char* kind;
  EventData (*read)(const std::string& detail);
};

using Text = const std::string&;

constexpr std::array<SortReader, 15> kSorts = {{
    {"kidnap", [](Text detail) -> EventData { return KidnapEvent{kidnap_named(detail)}; }},
    {"pick-up",
     [](Text detail) -> EventData {
       return sim::PickUp{
           value_or_text<OrText<sim::KidnapKind>, sim::KidnapKind>(kKidnapNames, detail)};
     }},
    {"collision", [](Text detail) -> EventData { return sim::Collision{collision_named(detail)}; }},
    {"fault on",
     [](Text detail) -> EventData {
       return sim::FaultEdge{fault_named(detail), true};
     }},
    {"fault off",
     [](Text detail) -> EventData {
       return sim::FaultEdge{fault_named(detail), false};
     }},
    {"driving", [](Text detail) -> EventData { return sim::Driving{driving_named(detail)}; }},
    {"world", [](Text detail) -> EventData { return WorldNews{news_named(detail)}; }},
    {"void", [](Text detail) -> EventData { return VoidEvent{void_reason_named(detail)}; }},
    {"alarm on", [](Text) -> EventData { return AlarmEvent{true}; }},
    {"alarm off", [](Text) -> EventData { return AlarmEvent{false}; }},
    {"recovery",
     [](Text detail) -> EventData {
       return RecoveryEvent{
           value_or_text<OrText<RecoveryEvent::From>, RecoveryEvent::From>(kRecoveryNames, detail)};
     }},
    {"warning", [](Text detail) -> EventData { return WarningEvent{detail}; }},
    {"operator",
     [](Text detail) -> EventData {
       return OperatorEvent{
           value_or_text<OrText<LocalizerOrder::What>, LocalizerOrder::What>(kOrderNames, detail)};
     }},
    {"localizer failed", [](Text detail) -> EventData { return FailureEvent{detail}; }},
    {"node", [](Text detail) -> EventData { return NodeEvent{detail}; }},
}};

}  // namespace

EventNames names_of(const EventData& what) {
  return std::visit([](const auto& sort) { return names_of_sort(sort); }, what);
}

std::optional<EventData> event_named(const std::string& kind, const std::string& detail) {
  const auto found = std::ranges::find(kSorts, kind, &SortReader::kind);
  if (found == kSorts.end()) return std::nullopt;
  return found->read(detail);
}

std::string part_name(sim::KidnapKind kind) { return text_of(kind); }
std::string part_name(LocalizerOrder::What order) { return text_of(order); }
std::string part_name(const KidnapEvent::How& how) { return text_of(how); }
std::string part_name(const sim::FaultEdge::What& what) { return text_of(what); }
std::string part_name(const sim::Driving::What& what) { return text_of(what); }
std::string part_name(const VoidEvent::Reason& reason) { return text_of(reason); }
std::string part_name(const LossCause& cause) { return text_of(cause); }

VoidEvent::Reason void_reason_named(const std::string& name) {
  return value_or_text<VoidEvent::Reason, sim::VoidReason>(kVoidNames, name);
}

LossCause cause_named(const std::string& name) {
  if (name == kStart) return UnknownStart{};
  if (name == kOrderedStart) return OrderedStart{};
  return kidnap_named(name);
}

}  // namespace castaway::testbed
