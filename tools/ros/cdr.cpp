#include "tools/ros/cdr.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace castaway::testbed {

CdrReader::CdrReader(std::string_view bytes) {
  if (bytes.size() < 4) throw std::runtime_error("the message ends in its CDR header");
  const auto first = static_cast<unsigned char>(bytes[0]);
  const auto second = static_cast<unsigned char>(bytes[1]);
  if (first != 0 || second > 1) {
    throw std::runtime_error(
        fmt::format("the message is encoded as {:02x} {:02x}; plain CDR (00 00, 00 01) is read",
                    first, second));
  }
  big_endian_ = second == 0;
  bytes_ = bytes.substr(4);
}

void CdrReader::get(bool& value) {
  std::uint8_t byte = 0;
  get(byte);
  value = byte != 0;
}

void CdrReader::get(std::string& text) {
  const std::uint32_t size = count_of();
  text.assign(bytes_.substr(at_, size));
  at_ += size;
  if (!text.empty() && text.back() == '\0') text.pop_back();
}

std::uint32_t CdrReader::count_of() {
  std::uint32_t count = 0;
  get(count);
  if (count > bytes_.size() - at_) {
    throw std::runtime_error(fmt::format("the message claims {} elements and has {} bytes left",
                                         count, bytes_.size() - at_));
  }
  return count;
}

void CdrReader::align(std::size_t size) {
  const std::size_t over = at_ % size;
  if (over == 0) return;
  need(size - over);
  at_ += size - over;
}

void CdrReader::need(std::uint64_t size) const {
  if (size > bytes_.size() - at_) throw std::runtime_error("the message ends too early");
}

void CdrReader::swap_bytes(char* bytes, std::size_t size, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) std::reverse(bytes + i * size, bytes + (i + 1) * size);
}

}  // namespace castaway::testbed
