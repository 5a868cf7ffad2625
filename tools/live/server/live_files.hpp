/// Files that pages bring to a live run, and reports of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace castaway::testbed {

/// Limits of what pages bring, together.
struct FileLimits {
  std::uint64_t bytes = std::uint64_t{256} << 20U;
  std::size_t files = 2000;
};

/// The largest file that a page may bring. [bytes]
inline constexpr std::uint64_t kLargestUpload = std::uint64_t{64} << 20U;

/// Keeps files in a folder of its own, which it makes for the first of them.
class LiveFiles {
 public:
  explicit LiveFiles(std::filesystem::path folder, FileLimits limits = {})
      : folder_(std::move(folder)), limits_(limits) {}

  /// Keeps a file, `name` being its path with slashes; one of the same name is replaced. Returns
  /// why it cannot, or an empty text.
  std::string keep(const std::string& name, std::string_view bytes);

 private:
  std::filesystem::path folder_;
  FileLimits limits_;
  std::uint64_t bytes_ = 0;  ///< Taken so far, also by files that were replaced.
  std::size_t files_ = 0;
};

/// The report at the path "/report/NUMBER" of a request, in the folder `reports`; nothing if there
/// is none.
std::optional<std::string> read_report(std::string_view path, const std::filesystem::path& reports);

}  // namespace castaway::testbed
