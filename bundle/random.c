// arc4random of glibc 2.36 for the wheel: libexpat and LLVM call it, and nothing else in the wheel
// needs a C library that new (scripts/releasing/older_glibc.py).
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/random.h>

void arc4random_buf(void* buffer, size_t size) {
  for (unsigned char* at = buffer; size > 0;) {
    const ssize_t got = getrandom(at, size, 0);
    if (got < 0 && errno != EINTR) abort();
    if (got <= 0) continue;
    at += got;
    size -= (size_t)got;
  }
}

uint32_t arc4random(void) {
  uint32_t number = 0;
  arc4random_buf(&number, sizeof(number));
  return number;
}
