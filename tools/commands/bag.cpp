// castaway bag: shows the contents of a ROS 2 bag.
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/commands/commands.hpp"
#include "tools/play/terminal.hpp"
#include "tools/ros/bag_json.hpp"
#include "tools/ros/bag_topics.hpp"
#include "tools/scenario/files/bag_folder.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct BagArguments {
  std::string bag;
  bool json = false;
  bool messages = false;
};

double seconds_of(std::int64_t ns) { return 1e-9 * static_cast<double>(ns); }

nlohmann::ordered_json to_json(const BagInventory& bag) {
  nlohmann::ordered_json json = {{"bag", bag.name},
                                 {"start_ns", bag.start_ns},
                                 {"duration_s", seconds_of(bag.end_ns - bag.start_ns)},
                                 {"messages", bag.messages},
                                 {"topics", nlohmann::ordered_json::array()},
                                 {"attachments", nlohmann::ordered_json::array()},
                                 {"metadata", bag.metadata}};
  for (const BagTopicInfo& topic : bag.topics) {
    json["topics"].push_back({{"name", topic.name},
                              {"type", topic.type},
                              {"encoding", topic.encoding},
                              {"messages", topic.messages}});
  }
  for (const McapAttachmentInfo& attachment : bag.attachments) {
    json["attachments"].push_back({{"name", attachment.name},
                                   {"media_type", attachment.media_type},
                                   {"bytes", attachment.size}});
  }
  return json;
}

/// "castaway 0.1.0, robot waffle": the short texts of a metadata record; of one with many, such as
/// the names of all objects, their number.
std::string summarise(const std::map<std::string, std::string>& texts) {
  constexpr std::size_t kMost = 12;
  constexpr std::size_t kLongest = 40;
  if (texts.size() > kMost) return fmt::format("{} entries (see --json)", texts.size());
  std::vector<std::string> parts;
  for (const auto& [key, value] : texts) {
    if (value.size() > kLongest || value.find('\n') != std::string::npos) continue;
    parts.push_back(fmt::format("{} {}", key, value));
  }
  if (parts.size() < texts.size()) parts.emplace_back("... (see --json)");
  return fmt::format("{}", fmt::join(parts, ", "));
}

void print_metadata(const BagInventory& bag) {
  constexpr std::size_t kMostRecords = 4;
  std::size_t shown = 0;
  for (const auto& [name, texts] : bag.metadata) {
    if (shown++ == kMostRecords) {
      print_out("Metadata:  {} more records (see --json)\n", bag.metadata.size() - kMostRecords);
      break;
    }
    print_out("Metadata:  {}: {}\n", name, summarise(texts));
  }
}

void print_words(const BagInventory& bag) {
  print_out("Bag:       {}\n", bag.name);
  print_out("Duration:  {:.3f} s from {:.9f} s on\n", seconds_of(bag.end_ns - bag.start_ns),
            seconds_of(bag.start_ns));
  print_out("Messages:  {}\n", bag.messages);
  for (const BagTopicInfo& topic : bag.topics) {
    print_out("  {:>8}  {:<32} {}\n", topic.messages, topic.name, topic.type);
  }
  for (const McapAttachmentInfo& attachment : bag.attachments) {
    print_out("Attached:  {} ({} bytes)\n", attachment.name, attachment.size);
  }
  print_metadata(bag);
}

/// Prints each message as one line of JSON, without fields if its type is unknown.
void print_messages(const std::vector<std::filesystem::path>& files) {
  using Json = nlohmann::ordered_json;
  for (const auto& file : files) {
    BagFile reader(file);
    while (const auto message = reader.next()) {
      const McapSchema* schema = reader.schema_of(*message->channel);
      const std::string type = schema != nullptr ? schema->name : "";
      Json json = {{"topic", message->channel->topic}, {"log_time_ns", message->log_time_ns}};
      if (message->channel->encoding == "cdr") {
        if (auto fields = message_json(type, message->data)) json["message"] = std::move(*fields);
      }
      print_out("{}\n", json_text(json));
    }
  }
}

int describe_bag(const BagArguments& arguments) {
  const std::vector<std::filesystem::path> files = bag_files(arguments.bag);
  if (arguments.messages) {
    print_messages(files);
    return kDone;
  }
  const BagInventory bag = take_inventory(arguments.bag, files);
  for (const std::string& warning : bag.warnings) {
    print_warning(warning);
  }
  if (arguments.json) {
    print_out("{}\n", json_text(to_json(bag), 1));
  } else {
    print_words(bag);
  }
  return kDone;
}

}  // namespace

void add_bag_command(Command& app) {
  auto a = std::make_shared<BagArguments>();
  Command command = app.add_command(
      "bag", "Show the topics, types and message counts of a ROS 2 bag (MCAP or sqlite3)");
  command
      .add_option("bag", a->bag, "A bag's folder, a run folder with one, or an .mcap or .db3 file")
      .required();
  command.add_flag("--json", a->json, "Print JSON");
  command.add_flag("--messages", a->messages, "Print every message as a line of JSON");
  command.footer(
      "Examples:\n"
      "  castaway bag runs/lab-kidnap/seed-1\n"
      "  castaway bag rosbag2_2026_01_31 --messages | grep '\"/odom\"' | head");
  command.action([a] { return describe_bag(*a); });
}

}  // namespace castaway::testbed
