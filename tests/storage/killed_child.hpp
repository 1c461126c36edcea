#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <functional>

namespace weft::storage {

/// Runs `work` in a child process, kills it with -9 once it has reported `reports` times and `microseconds` more have
/// passed, and returns the last number that it reported; 0 when it ended by itself. `work` gets the function to
/// report through. Fork only: no threads may run.
inline std::uint64_t run_and_kill(int reports, unsigned microseconds,
                                  const std::function<void(const std::function<void(std::uint64_t)>&)>& work) {
  int ends[2] = {-1, -1};
  if (::pipe(ends) != 0) return 0;
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    work([&](std::uint64_t number) {
      if (::write(ends[1], &number, sizeof number) != sizeof number) ::_exit(1);
    });
    ::_exit(0);
  }
  ::close(ends[1]);
  std::uint64_t last = 0;
  std::uint64_t number = 0;
  int got = 0;
  while (got < reports && ::read(ends[0], &number, sizeof number) == sizeof number) {
    last = number;
    ++got;
  }
  const bool has_ended = got < reports;
  ::usleep(microseconds);  // the moment of death is this test's input
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  while (::read(ends[0], &number, sizeof number) == sizeof number) last = number;
  ::close(ends[0]);
  return has_ended ? 0 : last;
}

}  // namespace weft::storage
