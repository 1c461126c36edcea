#include <cstdio>
#include <cstring>
#include <exception>

#include "process/health_file.hpp"

namespace {

constexpr const char* kHelp =
    "weft-health DIR\n"
    "Says how the weft-server or weft-agent is that works in DIR (its --store or --state), as its --health does, and "
    "is\n"
    "quicker to start. Exit codes: 0 healthy, 1 not healthy (one line says why), 2 wrong usage\n";

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 2 && std::strcmp(argv[1], "--help") == 0) return std::fputs(kHelp, stdout) < 0 ? 1 : 0;
    if (argc == 2 && std::strcmp(argv[1], "--version") == 0)
      return std::puts("weft-health " WEFT_VERSION) < 0 ? 1 : 0;
    if (argc == 2 && argv[1][0] != '-' && argv[1][0] != '\0')
      return weft::process::report_health("weft-health", argv[1]);
    std::fputs("weft-health: give the one directory that is looked into: weft-health DIR\n", stderr);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "weft-health: ended by a defect: %s\n", error.what());
  }
  return 1;
}
