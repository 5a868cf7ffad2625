/* A library for another version of the interface. */
#include <castaway/localizer.h>

const castaway_localizer_functions* castaway_localizer(void) {
  static const castaway_localizer_functions functions = {.size = 16, .version = 0};
  return &functions;
}
