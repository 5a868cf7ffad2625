/* A shared library that is no localizer. */
int castaway_is_elsewhere(void) { return 1; }
