#include "tools/base/files/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "tools/base/files/file_error.hpp"

namespace castaway::testbed {

FolderLock::FolderLock(const std::filesystem::path& folder, double patience_s) {
  handle_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle_ < 0) {
    throw FileError(folder.string() + ": cannot be opened (" + std::strerror(errno) +
                    "); choose another folder with --out");
  }
  constexpr double kPause = 0.1;  // [s]
  for (double waited = 0.0;; waited += kPause) {
    if (::flock(handle_, LOCK_EX | LOCK_NB) == 0) return;
    if (errno != EWOULDBLOCK) return;  // The file system does not support locks.
    if (waited >= patience_s) break;
    std::this_thread::sleep_for(std::chrono::duration<double>(kPause));
  }
  ::close(handle_);
  throw std::runtime_error(folder.string() +
                           ": another castaway process is using it; wait until it ends or choose "
                           "another folder with --out");
}

FolderLock::~FolderLock() { ::close(handle_); }

}  // namespace castaway::testbed
