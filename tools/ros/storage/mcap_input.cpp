#include "tools/ros/storage/mcap_input.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "tools/ros/storage/mcap_records.hpp"

namespace castaway::testbed {

McapInput::McapInput(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {
  stream_->seekg(0, std::ios::end);
  size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(stream_->tellg(), 0));
  const std::uint64_t magic = kMcapMagic.size();
  if (size_ >= 2 * magic) {
    position_ = size_ - magic;
    closed_ = read(magic) == kMcapMagic;
  }
  position_ = 0;
  if (size_ < magic || read(magic) != kMcapMagic) {
    throw std::runtime_error(name_ + ": is not an MCAP file: its first bytes differ");
  }
}

std::string McapInput::read(std::uint64_t size) {
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream_->seekg(static_cast<std::streamoff>(position_));
  stream_->read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uint64_t>(stream_->gcount()) != size) fail("cannot be read here");
  position_ += size;
  return bytes;
}

std::string McapInput::describe(const std::string& why) const {
  return fmt::format("{}: byte {}: {}", name_, record_, why);
}

void McapInput::fail(const std::string& why) const {
  throw std::runtime_error(
      describe(why) + "; copy the file again, or save what can be read of it with 'mcap recover'");
}

}  // namespace castaway::testbed
