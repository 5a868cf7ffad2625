#include "tools/ros/storage/mcap_summary.hpp"

#include <utility>

#include <zlib.h>

namespace castaway::testbed {
namespace {

/// Concatenates the groups of a summary and records their offsets.
class Groups {
 public:
  explicit Groups(std::uint64_t start) : start_(start) {}

  /// Adds a group of `count` records, each appended by `append(bytes, index)`.
  template <typename Append>
  void add(McapOpcode opcode, std::size_t count, Append&& append) {
    if (count == 0) return;
    const std::size_t begin = bytes_.size();
    for (std::size_t i = 0; i < count; ++i) append(bytes_, i);
    places_.push_back({opcode, begin, bytes_.size() - begin});
  }
  std::string finish();

 private:
  struct Place {
    McapOpcode opcode;
    std::size_t offset;
    std::size_t length;
  };
  std::uint64_t start_;
  std::string bytes_;
  std::vector<Place> places_;
};

std::string Groups::finish() {
  const std::uint64_t offsets_start = start_ + bytes_.size();
  for (const Place& place : places_) {
    const std::size_t begin = begin_record(bytes_, McapOpcode::kSummaryOffset);
    append_number(bytes_, static_cast<std::uint8_t>(place.opcode));
    append_number(bytes_, start_ + place.offset);
    append_number(bytes_, static_cast<std::uint64_t>(place.length));
    end_record(bytes_, begin);
  }
  const std::size_t footer = begin_record(bytes_, McapOpcode::kFooter);
  append_number(bytes_, start_);
  append_number(bytes_, offsets_start);
  append_number(bytes_, std::uint32_t{0});
  end_record(bytes_, footer);
  bytes_.resize(bytes_.size() - sizeof(std::uint32_t));  // The checksum covers everything before
                                                         // it.
  const auto* data = reinterpret_cast<const Bytef*>(bytes_.data());
  append_number(bytes_, static_cast<std::uint32_t>(crc32_z(0, data, bytes_.size())));
  return std::move(bytes_.append(kMcapMagic));
}

void append_counts(std::string& bytes, const std::map<std::uint16_t, std::uint64_t>& counts) {
  std::string body;
  for (const auto& [channel, count] : counts) {
    append_number(body, channel);
    append_number(body, count);
  }
  append_text(bytes, body);
}

void append_statistics(std::string& bytes, const McapSummary& summary) {
  const std::size_t begin = begin_record(bytes, McapOpcode::kStatistics);
  const McapStatistics& statistics = summary.statistics;
  append_number(bytes, statistics.messages);
  append_number(bytes, static_cast<std::uint16_t>(summary.schemas.size()));
  append_number(bytes, static_cast<std::uint32_t>(summary.channels.size()));
  append_number(bytes, static_cast<std::uint32_t>(summary.attachments.size()));
  append_number(bytes, static_cast<std::uint32_t>(summary.metadata.size()));
  append_number(bytes, static_cast<std::uint32_t>(summary.chunks.size()));
  append_number(bytes, statistics.times.first);
  append_number(bytes, statistics.times.last);
  append_counts(bytes, statistics.messages_of);
  end_record(bytes, begin);
}

void append_chunk_place(std::string& bytes, const McapChunkPlace& chunk) {
  const std::size_t begin = begin_record(bytes, McapOpcode::kChunkIndex);
  append_number(bytes, chunk.times.first);
  append_number(bytes, chunk.times.last);
  append_number(bytes, chunk.offset);
  append_number(bytes, chunk.length);
  append_counts(bytes, chunk.index_of);
  append_number(bytes, chunk.index_length);
  append_text(bytes, chunk.compression);
  append_number(bytes, chunk.packed_size);
  append_number(bytes, chunk.size);
  end_record(bytes, begin);
}

void append_attachment_place(std::string& bytes, const McapPlace& place) {
  const std::size_t begin = begin_record(bytes, McapOpcode::kAttachmentIndex);
  append_number(bytes, place.offset);
  append_number(bytes, place.length);
  append_number(bytes, place.log_time);
  append_number(bytes, place.log_time);  // Creation time.
  append_number(bytes, place.data_size);
  append_text(bytes, place.name);
  append_text(bytes, place.media_type);
  end_record(bytes, begin);
}

void append_metadata_place(std::string& bytes, const McapPlace& place) {
  const std::size_t begin = begin_record(bytes, McapOpcode::kMetadataIndex);
  append_number(bytes, place.offset);
  append_number(bytes, place.length);
  append_text(bytes, place.name);
  end_record(bytes, begin);
}

}  // namespace

void append_schema(std::string& bytes, std::uint16_t id, const McapSchema& schema) {
  const std::size_t begin = begin_record(bytes, McapOpcode::kSchema);
  append_number(bytes, id);
  append_text(bytes, schema.name);
  append_text(bytes, schema.encoding);
  append_text(bytes, schema.data);
  end_record(bytes, begin);
}

void append_channel(std::string& bytes, std::uint16_t id, const McapChannel& channel) {
  const std::size_t begin = begin_record(bytes, McapOpcode::kChannel);
  append_number(bytes, id);
  append_number(bytes, channel.schema);
  append_text(bytes, channel.topic);
  append_text(bytes, channel.encoding);
  append_texts(bytes, channel.metadata);
  end_record(bytes, begin);
}

std::string summary_bytes(const McapSummary& summary, std::uint64_t start) {
  Groups groups(start);
  groups.add(McapOpcode::kSchema, summary.schemas.size(), [&](std::string& bytes, std::size_t i) {
    append_schema(bytes, static_cast<std::uint16_t>(i + 1), summary.schemas[i]);
  });
  groups.add(McapOpcode::kChannel, summary.channels.size(), [&](std::string& bytes, std::size_t i) {
    append_channel(bytes, static_cast<std::uint16_t>(i), summary.channels[i]);
  });
  groups.add(McapOpcode::kStatistics, 1,
             [&](std::string& bytes, std::size_t) { append_statistics(bytes, summary); });
  groups.add(McapOpcode::kMetadataIndex, summary.metadata.size(),
             [&](std::string& bytes, std::size_t i) {
               append_metadata_place(bytes, summary.metadata[i]);
             });
  groups.add(McapOpcode::kAttachmentIndex, summary.attachments.size(),
             [&](std::string& bytes, std::size_t i) {
               append_attachment_place(bytes, summary.attachments[i]);
             });
  groups.add(
      McapOpcode::kChunkIndex, summary.chunks.size(),
      [&](std::string& bytes, std::size_t i) { append_chunk_place(bytes, summary.chunks[i]); });
  return groups.finish();
}

}  // namespace castaway::testbed
