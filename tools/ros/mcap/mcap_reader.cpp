#include "tools/ros/mcap/mcap_reader.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "tools/files/file.hpp"
#include "tools/ros/mcap/mcap_chunk.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint64_t kMostOfNames = 1 << 16;
constexpr std::uint64_t kLargestRecord = std::uint64_t{256} << 20U;

/// Whether records of a kind are parsed; others are skipped.
bool is_read(McapOpcode opcode) {
  return opcode == McapOpcode::kSchema || opcode == McapOpcode::kChannel ||
         opcode == McapOpcode::kMessage || opcode == McapOpcode::kChunk ||
         opcode == McapOpcode::kMetadata;
}

}  // namespace

McapReader::McapReader(const std::filesystem::path& path)
    : stream_(
          (require_regular_file(path), std::make_unique<std::ifstream>(path, std::ios::binary))),
      name_(path.string()) {
  if (!*stream_) {
    throw std::runtime_error(name_ + ": cannot be read; check the path and its permissions");
  }
  open();
}

McapReader::McapReader(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {
  open();
}

void McapReader::open() {
  stream_->seekg(0, std::ios::end);
  size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(stream_->tellg(), 0));
  const std::uint64_t magic = kMcapMagic.size();
  if (size_ >= 2 * magic) {
    position_ = size_ - magic;
    closed_ = read_bytes(magic) == kMcapMagic;
  }
  position_ = 0;
  if (size_ < magic || read_bytes(magic) != kMcapMagic) {
    throw std::runtime_error(name_ + ": is not an MCAP file: its first bytes differ");
  }
}

void McapReader::fail(const std::string& why) const {
  throw std::runtime_error(
      fmt::format("{}: byte {}: {}; copy the file again, or save what can be read of it with 'mcap "
                  "recover'",
                  name_, record_, why));
}

/// Reads bytes at the current position; they must exist.
std::string McapReader::read_bytes(std::uint64_t size) {
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream_->seekg(static_cast<std::streamoff>(position_));
  stream_->read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uint64_t>(stream_->gcount()) != size) fail("cannot be read here");
  position_ += size;
  return bytes;
}

void McapReader::note_end(const std::string& why) {
  done_ = true;
  if (!closed_) {
    warning_ = fmt::format("{}: byte {}: {}; read up to there", name_, record_, why);
  }
}

/// Reads kind and length of the next record; nothing at the end.
std::optional<McapReader::Head> McapReader::read_head() {
  record_ = position_;
  if (size_ - position_ < kMcapRecordHead) {
    if (closed_) fail("the data end without a DataEnd record");
    note_end("the file ends here, unfinished");
    return std::nullopt;
  }
  const std::string bytes = read_bytes(kMcapRecordHead);
  ByteReader reader(bytes);
  Head head;
  head.opcode = static_cast<McapOpcode>(reader.number<std::uint8_t>());
  head.length = reader.number<std::uint64_t>();
  if (static_cast<int>(head.opcode) == 0) fail("this is no record: its kind is 0");
  return head;
}

/// Reads the available part of a record that extends beyond the end of the file.
bool McapReader::cut_short(const Head& head) {
  if (closed_) {
    fail(fmt::format("the record claims {} bytes, more than the file has left", head.length));
  }
  note_end("the file ends within the record that begins here, unfinished");
  if (head.opcode != McapOpcode::kChunk) return false;
  try {
    take_chunk(read_bytes(size_ - position_), false);
  } catch (const std::runtime_error&) {
    chunk_.clear();  // The fields before the messages are incomplete.
  }
  return true;
}

/// Reads a record; false at the end.
bool McapReader::read_record() {
  const std::optional<Head> head = done_ ? std::nullopt : read_head();
  if (!head) return false;
  if (head->length > size_ - position_) return cut_short(*head);
  if (head->opcode == McapOpcode::kAttachment) {
    take_attachment(head->length);
  } else if (head->opcode == McapOpcode::kDataEnd || head->opcode == McapOpcode::kFooter) {
    note_end("the file ends without its closing bytes, unfinished");
  } else if (!is_read(head->opcode)) {
    position_ += head->length;
  } else {
    if (head->length > kLargestRecord) {
      fail(fmt::format("a record of {} MiB: at most {} are read", head->length >> 20U,
                       kLargestRecord >> 20U));
    }
    take(head->opcode, read_bytes(head->length));
  }
  return !done_;
}

void McapReader::take(McapOpcode opcode, std::string content) {
  try {
    ByteReader record(content);
    if (opcode == McapOpcode::kSchema) take_schema(record);
    if (opcode == McapOpcode::kChannel) take_channel(record);
    if (opcode == McapOpcode::kChunk) take_chunk(content, true);
    if (opcode == McapOpcode::kMetadata) {
      const std::string name = record.text();
      metadata_[name] = record.texts();
    }
    if (opcode == McapOpcode::kMessage) {
      message_ = std::move(content);
      has_message_ = true;
    }
  } catch (const std::runtime_error& error) {
    fail(error.what());
  }
}

void McapReader::take_schema(ByteReader& record) {
  const auto id = record.number<std::uint16_t>();
  if (id == 0) throw std::runtime_error("a schema has the id 0");
  McapSchema schema;
  schema.name = record.text();
  schema.encoding = record.text();
  schema.data = record.text();
  schemas_.try_emplace(id, std::move(schema));
}

void McapReader::take_channel(ByteReader& record) {
  const auto id = record.number<std::uint16_t>();
  McapChannel channel;
  channel.schema = record.number<std::uint16_t>();
  channel.topic = record.text();
  channel.encoding = record.text();
  channel.metadata = record.texts();
  if (channel.schema != 0 && !schemas_.contains(channel.schema)) {
    throw std::runtime_error(
        fmt::format("channel {} has schema {}, which does not exist", id, channel.schema));
  }
  channels_.try_emplace(id, std::move(channel));
}

void McapReader::take_chunk(std::string_view content, bool whole) {
  chunk_ = open_chunk(content, whole);
  chunk_at_ = 0;
  chunk_whole_ = whole;
}

/// Records the name of an attachment and skips its data.
void McapReader::take_attachment(std::uint64_t length) {
  const std::uint64_t end = position_ + length;
  const std::string head = read_bytes(std::min(length, kMostOfNames));
  try {
    ByteReader record(head);
    record.take(2 * sizeof(std::uint64_t));
    McapAttachmentInfo info;
    info.name = record.text();
    info.media_type = record.text();
    info.size = record.number<std::uint64_t>();
    attachments_.push_back(std::move(info));
  } catch (const std::runtime_error& error) {
    fail(fmt::format("an attachment {}", error.what()));
  }
  position_ = end;
}

McapMessage McapReader::message_of(std::string_view content) const {
  ByteReader record(content);
  const auto channel = record.number<std::uint16_t>();
  record.take(sizeof(std::uint32_t));
  McapMessage message;
  message.log_time_ns = static_cast<std::int64_t>(record.number<std::uint64_t>());
  record.take(sizeof(std::uint64_t));
  const auto found = channels_.find(channel);
  if (found == channels_.end()) {
    throw std::runtime_error(
        fmt::format("a message has channel {}, which does not exist", channel));
  }
  message.channel = &found->second;
  message.data = record.take(record.rest());
  return message;
}

/// The next message of the current chunk.
std::optional<McapMessage> McapReader::next_of_chunk() {
  while (chunk_at_ < chunk_.size()) {
    ByteReader reader(std::string_view(chunk_).substr(chunk_at_));
    try {
      const auto opcode = static_cast<McapOpcode>(reader.number<std::uint8_t>());
      const std::string_view content = reader.take(reader.number<std::uint64_t>());
      ByteReader record(content);
      chunk_at_ += reader.position();
      if (opcode == McapOpcode::kSchema) take_schema(record);
      if (opcode == McapOpcode::kChannel) take_channel(record);
      if (opcode == McapOpcode::kMessage) return message_of(content);
    } catch (const std::runtime_error& error) {
      chunk_at_ = chunk_.size();
      if (chunk_whole_) fail(fmt::format("in the chunk here: {}", error.what()));
    }
  }
  return std::nullopt;
}

std::optional<McapMessage> McapReader::next() {
  do {
    if (auto message = next_of_chunk()) return message;
    if (!std::exchange(has_message_, false)) continue;
    try {
      return message_of(message_);
    } catch (const std::runtime_error& error) {
      fail(error.what());
    }
  } while (read_record() || chunk_at_ < chunk_.size());
  return std::nullopt;
}

const McapSchema* McapReader::schema_of(const McapChannel& channel) const {
  const auto found = schemas_.find(channel.schema);
  return found == schemas_.end() ? nullptr : &found->second;
}

}  // namespace castaway::testbed
