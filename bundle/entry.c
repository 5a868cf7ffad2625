// Where the bundled program begins. The kernel takes a program's dynamic loader from an absolute
// path, and the bundle's lies beside the program. So the program names none: it maps the bundle's
// loader itself and goes on there, as if the kernel had done so. It stays what /proc/self/exe
// names, its arguments stay as they are, and no variable passes to the programs that it starts.
//
// Nothing has relocated the program yet: this file calls no library and refers to hidden symbols
// only.
#include <elf.h>
#include <fcntl.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/mman.h>
#include <sys/syscall.h>

enum { kPage = 4096, kMostHeaders = 32 };

static const char kLoader[] = "/lib/ld-linux-x86-64.so.2";  // Below the folder above the program's.

__asm__(
    ".globl castaway_bundle_entry\n"
    ".hidden castaway_bundle_entry\n"
    ".type castaway_bundle_entry, @function\n"
    "castaway_bundle_entry:\n"
    "  xor %ebp, %ebp\n"
    "  mov %rsp, %rbx\n"
    "  mov %rsp, %rdi\n"
    "  and $-16, %rsp\n"
    "  call castaway_map_loader\n"
    "  mov %rbx, %rsp\n"
    "  xor %edx, %edx\n"
    "  jmp *%rax\n");

extern void _start(void) __attribute__((visibility("hidden")));
extern const Elf64_Ehdr __ehdr_start __attribute__((visibility("hidden")));  // The linker's.

/// The program's headers behind the two that the linker writes only for programs that name a
/// loader: from one the loader learns where the program is, from the other its own name.
static Elf64_Phdr headers[2 + kMostHeaders];
static char loader[kPage];  // Its path.

static long call(long number, long a, long b, long c, long d, long e, long f) {
  long result = 0;
  register long r10 __asm__("r10") = d;
  register long r8 __asm__("r8") = e;
  register long r9 __asm__("r9") = f;
  __asm__ volatile("syscall"
                   : "=a"(result)
                   : "a"(number), "D"(a), "S"(b), "d"(c), "r"(r10), "r"(r8), "r"(r9)
                   : "rcx", "r11", "memory");
  return result;
}

static size_t length_of(const char* text) {
  size_t length = 0;
  while (text[length] != '\0') ++length;
  return length;
}

static void say(const char* text) {
  call(SYS_write, 2, (long)text, (long)length_of(text), 0, 0, 0);
}

__attribute__((noreturn)) static void fail(const char* what, const char* file) {
  say("castaway: ");
  say(what);
  say(file);
  say("; unpack the whole archive, and run castaway/bin/castaway\n");
  while (1) call(SYS_exit_group, 1, 0, 0, 0, 0, 0);
}

static void find_loader(void) {
  const long most = kPage - (long)sizeof(kLoader);
  long length = call(SYS_readlink, (long)"/proc/self/exe", (long)loader, most, 0, 0, 0);
  if (length <= 0 || length >= most) fail("cannot read ", "/proc/self/exe");
  for (int level = 0; level < 2; ++level) {
    while (length > 0 && loader[--length] != '/') {
    }
  }
  for (size_t i = 0; i < sizeof(kLoader); ++i) loader[length + (long)i] = kLoader[i];
}

static uintptr_t page_of(uintptr_t address) { return address & ~(uintptr_t)(kPage - 1); }
static uintptr_t page_above(uintptr_t address) { return page_of(address + kPage - 1); }

static void* map(uintptr_t at, size_t size, int protection, int flags, int file, uintptr_t offset) {
  const long result = call(SYS_mmap, (long)at, (long)size, protection, flags, file, (long)offset);
  return result < 0 && result > -kPage ? MAP_FAILED : (void*)result;
}

/// Maps one segment of the file; returns 0 if the kernel refuses it.
static int map_segment(uintptr_t base, const Elf64_Phdr* segment, int file) {
  const int protection = ((segment->p_flags & PF_R) != 0 ? PROT_READ : 0) |
                         ((segment->p_flags & PF_W) != 0 ? PROT_WRITE : 0) |
                         ((segment->p_flags & PF_X) != 0 ? PROT_EXEC : 0);
  const uintptr_t begin = page_of(base + segment->p_vaddr);
  const uintptr_t of_file = base + segment->p_vaddr + segment->p_filesz;
  const uintptr_t end = page_above(base + segment->p_vaddr + segment->p_memsz);
  const int fixed = MAP_PRIVATE | MAP_FIXED;
  if (map(begin, of_file - begin, protection, fixed, file, page_of(segment->p_offset)) ==
      MAP_FAILED)
    return 0;
  if (segment->p_memsz == segment->p_filesz) return 1;
  const uintptr_t zeros = page_above(of_file);
  for (volatile char* byte = (char*)of_file; (uintptr_t)byte < zeros; ++byte) *byte = 0;
  return zeros >= end ||
         map(zeros, end - zeros, protection, fixed | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
}

/// Maps the loader; returns where it lies, and its entry.
static uintptr_t map_loader(uintptr_t* entry) {
  union {
    Elf64_Ehdr header;
    char bytes[sizeof(Elf64_Ehdr) + kMostHeaders * sizeof(Elf64_Phdr)];
  } head;
  const int file = (int)call(SYS_open, (long)loader, O_RDONLY | O_CLOEXEC, 0, 0, 0, 0);
  if (file < 0) fail("cannot open ", loader);
  const long got = call(SYS_read, file, (long)&head, sizeof(head), 0, 0, 0);
  const Elf64_Phdr* segments = (const Elf64_Phdr*)(head.bytes + head.header.e_phoff);
  if (got != sizeof(head) || head.header.e_phoff != sizeof(Elf64_Ehdr) ||
      head.header.e_phnum > kMostHeaders) {
    fail("is no dynamic loader: ", loader);
  }
  uintptr_t size = 0;
  for (int i = 0; i < head.header.e_phnum; ++i) {
    if (segments[i].p_type == PT_LOAD) size = page_above(segments[i].p_vaddr + segments[i].p_memsz);
  }
  const uintptr_t base = (uintptr_t)map(0, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  int good = base != (uintptr_t)MAP_FAILED;
  for (int i = 0; i < head.header.e_phnum && good; ++i) {
    if (segments[i].p_type == PT_LOAD) good = map_segment(base, &segments[i], file);
  }
  if (!good) fail("cannot map (is it on a disk that is mounted noexec?) ", loader);
  call(SYS_close, file, 0, 0, 0, 0, 0);
  *entry = base + head.header.e_entry;
  return base;
}

/// Returns the number of headers.
static size_t copy_headers(void) {
  const uintptr_t base = (uintptr_t)&__ehdr_start;
  const Elf64_Phdr* own = (const Elf64_Phdr*)(base + __ehdr_start.e_phoff);
  const size_t count = __ehdr_start.e_phnum;
  if (count > kMostHeaders) fail("too many headers in ", "the program");
  headers[0].p_type = PT_PHDR;
  headers[0].p_vaddr = (uintptr_t)headers - base;
  headers[1].p_type = PT_INTERP;
  headers[1].p_vaddr = (uintptr_t)loader - base;
  for (size_t i = 0; i < count; ++i) headers[2 + i] = own[i];
  return 2 + count;
}

/// `stack` is as the kernel left it: the arguments, the environment, and the auxiliary vector, in
/// which the loader finds the program. Returns the loader's entry.
__attribute__((used, visibility("hidden"))) uintptr_t castaway_map_loader(uintptr_t* stack) {
  uintptr_t entry = 0;
  find_loader();
  const uintptr_t base = map_loader(&entry);
  const size_t count = copy_headers();
  uintptr_t* word = stack + 1 + stack[0] + 1;  // Behind the arguments and their NULL.
  while (*word != 0) ++word;
  for (Elf64_auxv_t* fact = (Elf64_auxv_t*)(word + 1); fact->a_type != AT_NULL; ++fact) {
    if (fact->a_type == AT_BASE) fact->a_un.a_val = base;
    if (fact->a_type == AT_PHDR) fact->a_un.a_val = (uintptr_t)headers;
    if (fact->a_type == AT_PHNUM) fact->a_un.a_val = count;
    if (fact->a_type == AT_ENTRY) fact->a_un.a_val = (uintptr_t)&_start;
  }
  return entry;
}
