#include "tools/base/bytes/gzip.hpp"

#include <zlib.h>

#include <array>
#include <stdexcept>

namespace castaway::testbed {
namespace {

constexpr int kGzipWindow = 15 + 16;  // zlib's flag for a gzip header.
constexpr std::size_t kBlock = 1U << 16U;
constexpr std::size_t kMostBytes = 1U << 30U;  // A few bytes can expand to any number of them.

/// zlib takes non-const input but does not modify it.
void set_input(z_stream& stream, std::string_view bytes) {
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
}

/// Calls `step` (deflate or inflate) until it ends or fails; returns its output.
template <typename Step>
std::string pump(z_stream& stream, Step step, int& result) {
  std::string out;
  std::array<char, kBlock> block{};
  do {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    result = step(&stream);
    out.append(block.data(), block.size() - stream.avail_out);
  } while (result == Z_OK && out.size() <= kMostBytes);
  return out;
}

}  // namespace

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, 6, Z_DEFLATED, kGzipWindow, 9, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("gzip: no memory to compress");
  }
  set_input(stream, bytes);
  int result = Z_OK;
  std::string out = pump(
      stream, [](z_stream* s) { return deflate(s, Z_FINISH); }, result);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::runtime_error("gzip: could not compress");
  return out;
}

std::string gunzip(std::string_view stream_bytes) {
  z_stream stream{};
  if (inflateInit2(&stream, kGzipWindow) != Z_OK) {
    throw std::runtime_error("gunzip: no memory to expand");
  }
  set_input(stream, stream_bytes);
  int result = Z_OK;
  std::string out = pump(
      stream, [](z_stream* s) { return inflate(s, Z_NO_FLUSH); }, result);
  inflateEnd(&stream);
  if (result != Z_STREAM_END) {
    throw std::runtime_error("gunzip: not a gzip stream, or damaged, or cut off");
  }
  return out;
}

}  // namespace castaway::testbed
