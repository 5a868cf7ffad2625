#include "tools/build/bag/bag_reading.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "tools/build/bag/bag_collector.hpp"

namespace castaway::testbed {

BagRecording read_bag(const BagInventory& bag, const BagTopicChoice& topics,
                      const BagGround& ground) {
  BagCollector collector(bag, topics, ground);
  for (const auto& file : bag.files) {
    BagFile reader(file);
    while (const auto message = reader.next()) {
      const McapSchema* schema = reader.schema_of(*message->channel);
      try {
        collector.take(*message, schema != nullptr ? schema->name : "");
      } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}: topic {} at {} ns: {}", file.string(),
                                             message->channel->topic, message->log_time_ns,
                                             error.what()));
      }
    }
  }
  BagRecording recording = collector.finish();
  recording.warnings.insert(recording.warnings.begin(), bag.warnings.begin(), bag.warnings.end());
  return recording;
}

}  // namespace castaway::testbed
