#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <optional>
#include <random>

#include "clients/cli/commands.hpp"
#include "core/names.hpp"
#include "core/utf8.hpp"
#include "idl/bus/bus.hpp"
#include "idl/bus/link.hpp"

namespace {

using namespace weft;

std::string from_environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string{} : std::string(value);
}

std::uint64_t entropy() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32U) | device();
}

SteadyTime steady_now() {
  return SteadyTime{std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch())};
}

WallTime wall_now() {
  return WallTime{std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch())};
}

/// Keeps SIGINT and SIGTERM from this thread and all that are started after it, and tells whether one has come.
class Interrupts {
 public:
  Interrupts() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }
  bool came() {
    const timespec none{};
    has_come_ = has_come_ || sigtimedwait(&signals_, nullptr, &none) > 0;
    return has_come_;
  }

 private:
  sigset_t signals_{};
  bool has_come_ = false;
};

/// Returns whether a command ends by itself when it is interrupted; others are ended by the signal.
bool ends_by_itself(const cli::Invocation& invocation) {
  using Command = cli::Invocation::Command;
  return invocation.command == Command::bundle || (invocation.command == Command::events && invocation.follows);
}

/// Returns the name of who asks, as events show it.
std::string operator_name() {
  const std::string user = from_environment("USER");
  return user.empty() ? "uid" + std::to_string(getuid()) : as_utf8(user, kLongestName);
}

cli::Exit run(const cli::Invocation& invocation) {
  const cli::Output output{std::cout, std::cerr};
  if (!cli::needs_server(invocation.command)) return cli::run_offline(invocation, output);
  Random random(entropy());
  PeerId self;
  for (std::uint8_t& byte : self.bytes) byte = static_cast<std::uint8_t>(random.next() >> 8U);
  self = cli::identity(invocation, self);
  std::optional<Interrupts> interrupts;  // before the bus starts threads
  if (ends_by_itself(invocation)) interrupts.emplace();
  const Result<bus::Vendor> vendor = bus::parse_vendor(invocation.vendor);
  if (!vendor) return cli::report(vendor.error(), invocation.json, output);
  bus::BusConfig config;
  config.role = msg::Role::client;
  config.self = self;
  config.domain = invocation.domain;
  config.listen = invocation.listen;
  config.servers = invocation.servers;
  Result<std::unique_ptr<bus::Bus>> opened = bus::open(*vendor, config);
  if (!opened) return cli::report(opened.error(), invocation.json, output);
  bus::Link link(std::move(*opened));
  const auto wait = [&link](Duration at_most) {
    link.wait(at_most);
    for (const std::string& notice : link.bus().drain_notices()) std::cerr << "weft: " << notice << "\n";
  };
  const cli::World world{steady_now, wall_now, wait, [&interrupts] { return interrupts && interrupts->came(); }};
  cli::Session session(link, world, random, self, operator_name());
  return cli::run(session, invocation, output);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string libraries = ", with " + bus::library_version(bus::Vendor::fastdds) + " and " +
                                bus::library_version(bus::Vendor::cyclonedds);
  const auto parsed = cli::parse(argc, argv,
                                 {from_environment("WEFT_SERVER"), from_environment("WEFT_DDS"),
                                  from_environment("WEFT_LISTEN"), from_environment("WEFT_DOMAIN"), libraries});
  if (const auto* const not_run = std::get_if<cli::NotRun>(&parsed)) {
    return cli::report(*not_run, {std::cout, std::cerr});
  }
  return static_cast<int>(run(std::get<cli::Invocation>(parsed)));
} catch (const std::exception& error) {
  std::fprintf(stderr, "weft: ended by a defect: %s\n", error.what());
  return static_cast<int>(cli::Exit::failed);
}
