// A library to preload (LD_PRELOAD) that gives GCC's C++ compiler and clang-tidy memory in huge pages, their own code
// included: one fault and one entry of the TLB for 2 MB instead of 512. Every other program that it is loaded into is
// left as it is. What is asked for is the same, so what is compiled is the same. For programs of one thread.
#define _GNU_SOURCE
#include <fcntl.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

static const size_t kHuge = (size_t)2 << 20, kSmallest = (size_t)64 << 10, kLargest = (size_t)1 << 30, kChunk = (size_t)32 << 20;
static int wanted;                       // this process is a compiler
static char *next, *chunk_end;           // of the chunk that requests are served from
static uintptr_t lowest = UINTPTR_MAX, highest;  // of all chunks

static void* system_map(void* at, size_t bytes, int protection, int flags, int file, off_t offset) {
  return (void*)syscall(SYS_mmap, at, bytes, protection, flags, file, offset);
}

static size_t whole(size_t bytes, size_t unit) { return (bytes + unit - 1) / unit * unit; }

// Returns `bytes` (a multiple of 2 MB) in huge pages that are kept for such use; where none is left, in pages that the
// kernel may make huge; NULL without memory.
static char* chunk(size_t bytes) {
  char* at = system_map(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_HUGETLB, -1, 0);
  if (at == MAP_FAILED) {
    at = system_map(NULL, bytes + kHuge, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (at == MAP_FAILED) return NULL;
    at = (char*)whole((size_t)at, kHuge);
    madvise(at, bytes, MADV_HUGEPAGE);
  }
  if ((uintptr_t)at < lowest) lowest = (uintptr_t)at;
  if ((uintptr_t)at + bytes > highest) highest = (uintptr_t)at + bytes;
  return at;
}

static int is_plain(void* at, size_t bytes, int protection, int flags, int file) {
  const int special = MAP_FIXED | MAP_STACK | MAP_GROWSDOWN | MAP_HUGETLB;
  return at == NULL && file == -1 && (flags & MAP_ANONYMOUS) && (flags & MAP_PRIVATE) && !(flags & special) &&
         protection == (PROT_READ | PROT_WRITE) && bytes >= kSmallest && bytes <= kLargest;
}

void* mmap(void* at, size_t bytes, int protection, int flags, int file, off_t offset) {
  if (!wanted || !is_plain(at, bytes, protection, flags, file)) return system_map(at, bytes, protection, flags, file, offset);
  bytes = whole(bytes, 4096);
  if (next == NULL || bytes > (size_t)(chunk_end - next)) {
    const size_t more = bytes > kChunk ? whole(bytes, kHuge) : kChunk;
    char* fresh = chunk(more);
    if (fresh == NULL) return system_map(at, bytes, protection, flags, file, offset);
    next = fresh;
    chunk_end = fresh + more;
  }
  void* served = next;
  next += bytes;
  return served;
}

void* mmap64(void* at, size_t bytes, int protection, int flags, int file, off_t offset) {
  return mmap(at, bytes, protection, flags, file, offset);
}

// Keeps what lies in chunks until the process ends: a compiler does not live long.
int munmap(void* at, size_t bytes) {
  if (wanted && (uintptr_t)at >= lowest && (uintptr_t)at < highest) return 0;
  return (int)syscall(SYS_munmap, at, bytes);
}

// Replaces the whole huge pages of [from, to), a mapped file, by a copy in huge pages at the same addresses.
static void replace_by_huge(uintptr_t from, uintptr_t to) {
  from = whole(from, kHuge);
  to = to / kHuge * kHuge;
  if (to <= from) return;
  const int all = PROT_READ | PROT_WRITE | PROT_EXEC;
  char* copy = system_map(NULL, to - from, all, MAP_PRIVATE | MAP_ANONYMOUS | MAP_HUGETLB, -1, 0);
  if (copy == MAP_FAILED) return;
  memcpy(copy, (void*)from, to - from);
  if (mremap(copy, to - from, to - from, MREMAP_MAYMOVE | MREMAP_FIXED, (void*)from) == MAP_FAILED)
    syscall(SYS_munmap, copy, to - from);
}

struct mapped { uintptr_t from, to; };

// Writes the mapped files of 8 MB and more into `found`; returns how many they are. A file's neighbouring mappings are one.
static int large_files(struct mapped* found, int room) {
  static char maps[65536];
  const int file = open("/proc/self/maps", O_RDONLY);
  if (file < 0) return 0;
  size_t length = 0;
  for (ssize_t more; (more = read(file, maps + length, sizeof maps - 1 - length)) > 0;) length += (size_t)more;
  close(file);
  maps[length] = 0;
  static char name[512], last[512];
  int count = 0;
  for (char *line = maps, *end; *line && count < room; line = end + 1) {
    if ((end = strchr(line, '\n')) == NULL) break;
    *end = 0;
    unsigned long from = 0, to = 0;
    name[0] = 0;
    sscanf(line, "%lx-%lx %*s %*s %*s %*s %511s", &from, &to, name);
    if (name[0] == '/' && count > 0 && strcmp(name, last) == 0 && found[count - 1].to == from) found[count - 1].to = to;
    else if (name[0] == '/') found[count++] = (struct mapped){from, to};
    strcpy(last, name);
  }
  int large = 0;
  for (int at = 0; at < count; ++at)
    if (found[at].to - found[at].from >= (uintptr_t)8 << 20) found[large++] = found[at];
  return large;
}

__attribute__((constructor)) static void begin(void) {
  char program[512];
  const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
  if (length <= 0) return;
  program[length] = 0;
  wanted = strstr(program, "/cc1plus") != NULL || strstr(program, "clang-tidy") != NULL;
  if (!wanted) return;
  struct mapped files[128];
  const int count = large_files(files, 128);
  for (int at = 0; at < count; ++at) replace_by_huge(files[at].from, files[at].to);
}
