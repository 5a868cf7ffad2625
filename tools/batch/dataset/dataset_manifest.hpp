/// The list of a data set's files, with their sizes and checksums.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Path of the page of plots within a data set. The manifest does not list it, since its script
/// depends on the build.
inline constexpr const char* kPlotsPage = "plots/index.html";

/// A file of a data set.
struct ManifestFile {
  std::string path;  ///< Relative to the data set's folder, with slashes.
  std::uintmax_t bytes = 0;
  std::string sha256;  ///< 64 hexadecimal digits.
};

/// Lists every file in a folder and below, sorted by path. Throws std::runtime_error if one cannot
/// be read.
std::vector<ManifestFile> survey_files(const std::filesystem::path& folder);

/// Text of manifest.json, as `read_manifest` reads it.
std::string manifest_text(const std::vector<ManifestFile>& files);

/// Text of SHA256SUMS, for `sha256sum -c`.
std::string sums_text(const std::vector<ManifestFile>& files);

/// Throws std::runtime_error naming the file and what is wrong with it.
std::vector<ManifestFile> read_manifest(const std::filesystem::path& file);

/// Compares a data set with its manifest.json. Returns one line for each file that is missing,
/// changed or not listed. Throws std::runtime_error if there is no manifest.
std::vector<std::string> verify_dataset(const std::filesystem::path& folder);

}  // namespace castaway::testbed
