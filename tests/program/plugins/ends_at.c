/* Preloaded into castaway: counts the calls that rename or remove a file or a folder, in all its
 * processes together, in the file CASTAWAY_COUNT. At call CASTAWAY_AT it kills the process group,
 * or, if CASTAWAY_FULL is set, fails as on a full disk. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/types.h>
#include <unistd.h>

static atomic_uint* shared_count(void) {
  static atomic_uint* count = NULL;
  if (count != NULL) return count;
  const char* name = getenv("CASTAWAY_COUNT");
  const int file = name == NULL ? -1 : open(name, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0 || ftruncate(file, sizeof(atomic_uint)) != 0) abort();
  count = mmap(NULL, sizeof(atomic_uint), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  if (count == MAP_FAILED) abort();
  return count;
}

/* True if this call must fail. */
static int is_last(void) {
  const unsigned call = atomic_fetch_add(shared_count(), 1) + 1;
  const char* at = getenv("CASTAWAY_AT");
  if (at == NULL || call != (unsigned)atoi(at)) return 0;
  if (getenv("CASTAWAY_FULL") == NULL) kill(0, SIGKILL);
  errno = ENOSPC;
  return 1;
}

int rename(const char* from, const char* to) {
  if (is_last()) return -1;
  return ((int (*)(const char*, const char*))dlsym(RTLD_NEXT, "rename"))(from, to);
}

int unlinkat(int folder, const char* path, int flags) {
  if (is_last()) return -1;
  return ((int (*)(int, const char*, int))dlsym(RTLD_NEXT, "unlinkat"))(folder, path, flags);
}

int unlink(const char* path) {
  if (is_last()) return -1;
  return ((int (*)(const char*))dlsym(RTLD_NEXT, "unlink"))(path);
}

int remove(const char* path) {
  if (is_last()) return -1;
  return ((int (*)(const char*))dlsym(RTLD_NEXT, "remove"))(path);
}
