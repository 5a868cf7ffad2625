#include "tools/commands/run_folder_swap.hpp"

#include "tools/formats/file_error.hpp"

namespace castaway::testbed {

namespace fs = std::filesystem;

RunFolderSwap::RunFolderSwap(fs::path target) : target_(std::move(target)) {
  if (!target_.has_filename()) target_ = target_.parent_path();
  partial_ = target_;
  partial_ += ".partial";
  std::error_code error;
  fs::remove_all(partial_, error);
  fs::create_directories(target_, error);
  if (!error) fs::create_directories(partial_, error);
  if (error) {
    throw FileError(target_.string() + ": cannot be made (" + error.message() +
                    "); choose another folder with --out");
  }
}

RunFolderSwap::~RunFolderSwap() {
  std::error_code ignored;
  fs::remove_all(partial_, ignored);
  if (fs::is_empty(target_, ignored)) fs::remove(target_, ignored);
}

void RunFolderSwap::commit() {
  for (const char* name : {"snapshots", "bag", "kitti", "recording.gz", "log.carmen"}) {
    fs::remove_all(target_ / name);
  }
  for (const auto& entry : fs::directory_iterator(partial_)) {
    const fs::path place = target_ / entry.path().filename();
    if (entry.is_directory())
      fs::remove_all(place);  // A folder takes the place of an empty one only.
    fs::rename(entry.path(), place);
  }
}

}  // namespace castaway::testbed
