#include "tools/ros/storage/mcap_writer.hpp"

#include <limits>
#include <stdexcept>

#include <zlib.h>

#include "tools/base/bytes/compression.hpp"

namespace castaway::testbed {
namespace {

std::uint32_t checksum(std::uint32_t crc, std::string_view bytes) {
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(crc32_z(crc, data, bytes.size()));
}

template <typename Kind>
std::uint16_t next_id(const std::vector<Kind>& kinds, std::size_t first) {
  if (kinds.size() + first > std::numeric_limits<std::uint16_t>::max()) {
    throw std::invalid_argument("an MCAP file holds at most 65535 schemas and channels");
  }
  return static_cast<std::uint16_t>(kinds.size() + first);
}

void append_chunk(std::string& bytes, const McapChunkPlace& place, std::uint32_t crc,
                  std::string_view packed) {
  const std::size_t begin = begin_record(bytes, McapOpcode::kChunk);
  append_number(bytes, place.times.first);
  append_number(bytes, place.times.last);
  append_number(bytes, place.size);
  append_number(bytes, crc);
  append_text(bytes, place.compression);
  append_number(bytes, place.packed_size);
  bytes += packed;
  end_record(bytes, begin);
}

void append_message_index(std::string& bytes, std::uint16_t channel,
                          const McapMessageIndex& entries) {
  const std::size_t begin = begin_record(bytes, McapOpcode::kMessageIndex);
  append_number(bytes, channel);
  append_number(bytes, static_cast<std::uint32_t>(entries.size() * 2 * sizeof(std::uint64_t)));
  for (const auto& [time, offset] : entries) {
    append_number(bytes, time);
    append_number(bytes, offset);
  }
  end_record(bytes, begin);
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& path, McapOptions options)
    : file_(path), options_(std::move(options)) {
  std::string bytes(kMcapMagic);
  const std::size_t begin = begin_record(bytes, McapOpcode::kHeader);
  append_text(bytes, options_.profile);
  append_text(bytes, options_.library);
  end_record(bytes, begin);
  put(bytes);
}

std::uint16_t McapWriter::add_schema(McapSchema schema) {
  const std::uint16_t id = next_id(summary_.schemas, 1);
  summary_.schemas.push_back(std::move(schema));
  schema_written_.push_back(false);
  return id;
}

std::uint16_t McapWriter::add_channel(McapChannel channel) {
  if (channel.schema > summary_.schemas.size()) {
    throw std::invalid_argument("channel " + channel.topic + " has a schema that was not added");
  }
  const std::uint16_t id = next_id(summary_.channels, 0);
  summary_.channels.push_back(std::move(channel));
  channel_written_.push_back(false);
  return id;
}

/// Writes a channel and its schema before the channel's first message.
void McapWriter::introduce(std::uint16_t channel) {
  if (channel_written_[channel]) return;
  channel_written_[channel] = true;
  const std::uint16_t schema = summary_.channels[channel].schema;
  if (schema > 0 && !schema_written_[schema - 1U]) {
    schema_written_[schema - 1U] = true;
    append_schema(chunk_, schema, summary_.schemas[schema - 1U]);
  }
  append_channel(chunk_, channel, summary_.channels[channel]);
}

void McapWriter::write(std::uint16_t channel, std::int64_t log_time_ns, std::string_view message) {
  if (channel >= summary_.channels.size()) {
    throw std::invalid_argument("a message of a channel that was not added");
  }
  constexpr std::size_t kFixed = 2 + 4 + 8 + 8;
  if (chunk_.size() + kMcapRecordHead + kFixed + message.size() > options_.chunk_bytes) {
    flush_chunk();
  }
  introduce(channel);
  const auto time = static_cast<std::uint64_t>(log_time_ns);
  std::uint64_t& count = summary_.statistics.messages_of[channel];
  chunk_index_[channel].emplace_back(time, chunk_.size());
  append_number(chunk_, static_cast<std::uint8_t>(McapOpcode::kMessage));
  append_number(chunk_, static_cast<std::uint64_t>(kFixed + message.size()));
  append_number(chunk_, channel);
  append_number(chunk_, static_cast<std::uint32_t>(count));
  append_number(chunk_, time);
  append_number(chunk_, time);
  chunk_.append(message);
  ++count;
  ++summary_.statistics.messages;
  chunk_times_.add(time);
  summary_.statistics.times.add(time);
}

void McapWriter::flush_chunk() {
  if (chunk_index_.empty()) return;
  const std::string packed = pack_chunk(chunk_, options_.compression);
  McapChunkPlace place;
  place.times = chunk_times_;
  place.offset = position_;
  place.compression = compression_name(options_.compression);
  place.packed_size = packed.size();
  place.size = chunk_.size();
  std::string bytes;
  append_chunk(bytes, place, checksum(0, chunk_), packed);
  place.length = bytes.size();
  for (const auto& [channel, entries] : chunk_index_) {
    place.index_of[channel] = position_ + bytes.size();
    append_message_index(bytes, channel, entries);
  }
  place.index_length = bytes.size() - place.length;
  put(bytes);
  summary_.chunks.push_back(std::move(place));
  chunk_.clear();
  chunk_index_.clear();
  chunk_times_ = {};
}

void McapWriter::attach(const McapAttachment& attachment) {
  flush_chunk();
  const auto time = static_cast<std::uint64_t>(attachment.log_time_ns);
  std::string bytes;
  const std::size_t begin = begin_record(bytes, McapOpcode::kAttachment);
  append_number(bytes, time);
  append_number(bytes, time);
  append_text(bytes, attachment.name);
  append_text(bytes, attachment.media_type);
  append_number(bytes, static_cast<std::uint64_t>(attachment.data.size()));
  bytes += attachment.data;
  append_number(bytes, checksum(0, std::string_view(bytes).substr(kMcapRecordHead)));
  end_record(bytes, begin);
  summary_.attachments.push_back({position_, bytes.size(), time, attachment.data.size(),
                                  attachment.name, attachment.media_type});
  put(bytes);
}

void McapWriter::add_metadata(const std::string& name,
                              const std::map<std::string, std::string>& texts) {
  flush_chunk();
  std::string bytes;
  const std::size_t begin = begin_record(bytes, McapOpcode::kMetadata);
  append_text(bytes, name);
  append_texts(bytes, texts);
  end_record(bytes, begin);
  summary_.metadata.push_back({position_, bytes.size(), 0, 0, name, ""});
  put(bytes);
}

void McapWriter::put(std::string_view bytes) {
  file_.write(bytes);
  crc_ = checksum(crc_, bytes);
  position_ += bytes.size();
}

void McapWriter::finish() {
  flush_chunk();
  const std::uint32_t crc = crc_;
  std::string bytes;
  const std::size_t begin = begin_record(bytes, McapOpcode::kDataEnd);
  append_number(bytes, crc);
  end_record(bytes, begin);
  put(bytes);
  put(summary_bytes(summary_, position_));
  file_.commit();
}

}  // namespace castaway::testbed
