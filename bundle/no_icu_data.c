// A libicudata without data, 30 MB smaller: an empty table of contents of ICU's format. ICU comes into
// the wheel with libxml2, libxml2 with LLVM, which would read manifests of Windows with it; the
// renderer never does. CASTAWAY_ICU_DATA: the symbol that libicuuc looks for, icudt72_dat or so.
#include <stdint.h>

struct EmptyData {
  uint16_t header_size;
  uint8_t magic[2];
  uint16_t info_size, reserved;
  uint8_t big_endian, charset_family, char_size, reserved_byte;
  uint8_t format[4], format_version[4], data_version[4];
  uint8_t padding[8];
  uint32_t count, reserved_word;
};

__attribute__((aligned(16))) const struct EmptyData CASTAWAY_ICU_DATA = {
    .header_size = 32,
    .magic = {0xda, 0x27},
    .info_size = 20,
    .char_size = 2,
    .format = {'T', 'o', 'C', 'P'},
    .format_version = {1},
};
