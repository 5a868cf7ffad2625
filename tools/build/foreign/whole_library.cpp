#include "tools/build/foreign/whole_library.hpp"

#include <elf.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

/// Reads a structure; false at the end of the file.
template <typename Head>
bool read_at(std::ifstream& stream, std::uint64_t offset, Head& head) {
  stream.seekg(static_cast<std::streamoff>(offset));
  return static_cast<bool>(stream.read(reinterpret_cast<char*>(&head), sizeof(head)));
}

}  // namespace

void require_whole_library(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::exists(file, none)) return;
  require_regular_file(file);
  const std::uint64_t size = std::filesystem::file_size(file);
  std::ifstream stream(file, std::ios::binary);
  Elf64_Ehdr head{};
  if (!read_at(stream, 0, head) || std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0) return;
  if (head.e_ident[EI_CLASS] != ELFCLASS64) return;
  for (unsigned i = 0; i < head.e_phnum; ++i) {
    Elf64_Phdr segment{};
    const bool there = read_at(stream, head.e_phoff + i * sizeof(segment), segment);
    const std::uint64_t end = segment.p_offset + segment.p_filesz;
    if (there && end <= size && end >= segment.p_offset) continue;
    throw std::runtime_error(
        fmt::format("{}: is cut off after {} bytes; build or copy it again", file.string(), size));
  }
}

}  // namespace castaway::testbed
