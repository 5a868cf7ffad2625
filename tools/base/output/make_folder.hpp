/// Makes output folders.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "tools/base/files/file_error.hpp"

namespace castaway::testbed {

/// Makes a folder and those above it. Throws FileError if the disk is full, else
/// std::runtime_error: another folder would do.
inline void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  const std::string text = folder.string() + ": cannot be made (" + error.message() + ")";
  if (error == std::errc::no_space_on_device) throw FileError(text);
  throw std::runtime_error(text + "; choose another folder with --out");
}

}  // namespace castaway::testbed
