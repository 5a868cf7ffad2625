#include "tools/ros/storage/bag_file.hpp"

#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/bytes/compression.hpp"

namespace castaway::testbed {
namespace {

constexpr std::string_view kZstdMagic{"\x28\xB5\x2F\xFD", 4};
constexpr std::uint64_t kLargestMessage = std::uint64_t{256} << 20U;

std::variant<McapReader, SqliteBag> open_storage(const std::filesystem::path& path) {
  if (path.extension() == ".db3" || is_sqlite(path)) return SqliteBag(path);
  return McapReader(path);
}

}  // namespace

BagFile::BagFile(const std::filesystem::path& path)
    : name_(path.string()), reader_(open_storage(path)) {}

std::optional<McapMessage> BagFile::next() {
  auto message = std::visit([](auto& reader) { return reader.next(); }, reader_);
  if (!message || !message->data.starts_with(kZstdMagic)) return message;
  try {
    UnpackedChunk unpacked = unpack_chunk(message->data, "zstd", kLargestMessage);
    if (!unpacked.whole) throw std::runtime_error("it ends too early");
    unpacked_ = std::move(unpacked.bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: topic {} at {} ns: its compressed message: {}", name_,
                                         message->channel->topic, message->log_time_ns,
                                         error.what()));
  }
  message->data = unpacked_;
  return message;
}

const McapSchema* BagFile::schema_of(const McapChannel& channel) const {
  return std::visit([&](const auto& reader) { return reader.schema_of(channel); }, reader_);
}

std::vector<McapAttachmentInfo> BagFile::attachments() const {
  const auto* mcap = std::get_if<McapReader>(&reader_);
  return mcap != nullptr ? mcap->attachments() : std::vector<McapAttachmentInfo>();
}

std::map<std::string, std::map<std::string, std::string>> BagFile::metadata() const {
  const auto* mcap = std::get_if<McapReader>(&reader_);
  return mcap != nullptr ? mcap->metadata()
                         : std::map<std::string, std::map<std::string, std::string>>();
}

std::optional<std::string> BagFile::warning() const {
  const auto* mcap = std::get_if<McapReader>(&reader_);
  return mcap != nullptr ? mcap->warning() : std::nullopt;
}

}  // namespace castaway::testbed
