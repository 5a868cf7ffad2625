#include "tools/live/lines/bridge_link.hpp"

#include <cstring>
#include <map>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/live/lines/pipes.hpp"
#include "tools/live/lines/wire.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Before the message; both ends are on one machine.
struct MessageHead {
  std::int64_t stamp_ns = 0;
  std::uint32_t topic = 0;
  std::uint32_t unused = 0;
};

/// Topics by the link's numbers.
class LinkedTopics {
 public:
  explicit LinkedTopics(TopicWriter& wire) : wire_(wire) {}

  /// A topic that another run had is taken over.
  void add(const Json& said) {
    const auto name = said.at("name").get<std::string>();
    const auto type = said.at("type").get<std::string>();
    const auto [known, first] = known_.try_emplace({name, type});
    if (first) {
      const bool latched = said.at("latched").get<bool>();
      known->second = wire_.add(
          {name, type, latched ? Durability::kTransientLocal : Durability::kVolatile, 0}, "", {});
    }
    ids_[said.at("topic").get<std::uint32_t>()] = known->second;
  }
  void write(const std::string& body) {
    MessageHead head;
    if (body.size() < sizeof(head)) throw std::runtime_error("a message without its head");
    std::memcpy(&head, body.data(), sizeof(head));
    wire_.write(ids_.at(head.topic), Stamp(head.stamp_ns), body.substr(sizeof(head)));
  }

 private:
  TopicWriter& wire_;
  std::map<std::pair<std::string, std::string>, std::uint16_t> known_;  ///< By name and type.
  std::map<std::uint32_t, std::uint16_t> ids_;
};

}  // namespace

std::uint16_t BridgeLink::add(const BagTopic& topic, const char*,
                              std::map<std::string, std::string>) {
  const Json said = {{"topic", next_},
                     {"name", topic.name},
                     {"type", topic.type},
                     {"latched", topic.durability == Durability::kTransientLocal}};
  (void)write_whole(socket_, to_wire(WireKind::kSaid, json_text(said)));
  return next_++;
}

void BridgeLink::write(std::uint16_t topic, Stamp delivered, const std::string& message) {
  if (is_mute_) return;
  const MessageHead head{delivered.count(), topic, 0};
  std::string body(sizeof(head), '\0');
  std::memcpy(body.data(), &head, sizeof(head));
  (void)write_whole(socket_, to_wire(WireKind::kFrame, body + message));
}

void publish_link(int socket, TopicWriter& wire) {
  LinkedTopics topics(wire);
  WireReader reader;
  std::string bytes;
  while (read_more(socket, bytes)) {
    reader.take(std::exchange(bytes, {}));
    while (const auto message = reader.next()) {
      if (message->kind == WireKind::kSaid) {
        topics.add(Json::parse(message->body));
      } else {
        topics.write(message->body);
      }
    }
  }
}

}  // namespace castaway::testbed
