/// A run folder that appears when the run is complete, and never otherwise.
#pragma once

#include <filesystem>

namespace castaway::testbed {

/// A folder beside the target (`<target>.partial`) that takes the target's place on `commit`.
class RunFolderSwap {
 public:
  /// Throws std::runtime_error naming the folder if it cannot be made.
  explicit RunFolderSwap(std::filesystem::path target);
  /// Removes what was written unless `commit` was called.
  ~RunFolderSwap();
  RunFolderSwap(const RunFolderSwap&) = delete;
  RunFolderSwap& operator=(const RunFolderSwap&) = delete;

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& folder() const { return partial_; }
  /// Moves every file and folder into the target. Those of an earlier run are replaced; its
  /// pictures, recording, bag and logs are removed; other files stay.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path partial_;
};

}  // namespace castaway::testbed
