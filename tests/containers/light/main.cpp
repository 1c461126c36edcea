#include <atomic>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <thread>
#include <vector>

#include "tests/containers/light/newcomer.hpp"
#include "tests/containers/light/robot.hpp"

namespace {
using namespace weft;

/// Runs all robots, a thread each, until SIGINT or SIGTERM, or until one cannot go on. Returns the exit code.
int live(const light::Options& options, const sigset_t& signals) {
  const auto site = options.protocol == 0 ? light::site_of(options) : nullptr;
  std::atomic<bool> is_over = false;
  std::atomic<bool> has_failed = false;
  std::vector<std::jthread> robots;
  for (std::size_t number = options.first; number < options.first + options.robots; ++number) {
    robots.emplace_back([&, number] {
      try {
        const auto stop = [&] { return is_over.load(); };
        const Result<void> ended =
            site ? light::run_robot(options, site, number, stop) : light::run_newcomer(options, stop);
        if (ended) return;
        std::fprintf(stderr, "weft-light-agents: %s: %s\n", light::name_of(number).c_str(),
                     ended.error().message.c_str());
      } catch (const std::exception& error) {
        std::fprintf(stderr, "weft-light-agents: ended by a defect: %s\n", error.what());
      }
      has_failed = true;
    });
  }
  const timespec between{0, 100'000'000};
  while (!has_failed && sigtimedwait(&signals, nullptr, &between) < 0) {
  }
  is_over = true;
  robots.clear();
  return has_failed ? 1 : 0;
}

int run(int argc, char** argv) {
  const auto parsed = light::parse_options(argc, argv);
  if (const auto* const leave = std::get_if<light::Leave>(&parsed)) {
    std::fputs(leave->text.c_str(), leave->exit_code == 0 ? stdout : stderr);
    return leave->exit_code;
  }
  const auto& options = std::get<light::Options>(parsed);
  if (!options.lines.empty()) {
    const Result<void> written = light::write_lines(options);
    if (!written) std::fprintf(stderr, "weft-light-agents: %s\n", written.error().message.c_str());
    return written ? 0 : 1;
  }
  sigset_t signals{};
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // in all threads; one waits for them
  return live(options, signals);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "weft-light-agents: ended by a defect: %s\n", error.what());
  }
  return 1;
}
