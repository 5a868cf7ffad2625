/// The HDF5 group's own reader, if it is installed.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace castaway::testbed {

inline bool h5dump_works() { return std::system("h5dump --version >/dev/null 2>&1") == 0; }

/// Output of `h5dump <arguments> <file>`.
inline std::string h5dump(const std::filesystem::path& file, const std::string& arguments) {
  const std::string command = "h5dump " + arguments + " '" + file.string() + "' 2>&1";
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return "";
  std::string text;
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    text.append(buffer.data(), n);
  }
  ::pclose(pipe);
  return text;
}

}  // namespace castaway::testbed
