#include "tests/containers/light/newcomer.hpp"

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <thread>

#include "agents/agent/process/identity.hpp"
#include "core/random.hpp"
#include "tests/containers/light/open_link.hpp"

namespace weft::light {
namespace {
constexpr Duration kBetweenGreetings = std::chrono::milliseconds(500);

msg::Hello greeting_of(const Options& options, const RobotId& self, Random& random) {
  msg::Hello hello;
  hello.peer = self;
  hello.incarnation = random.next() | 1U;
  hello.protocol_min = hello.protocol_max = static_cast<std::uint16_t>(options.protocol);
  hello.name = name_of(options.first);
  hello.software = WEFT_VERSION "-next";
  hello.vendor = options.vendor == bus::Vendor::fastdds ? "fastdds" : "cyclonedds";
  hello.challenge = random.next() | 1U;
  return hello;
}

}  // namespace

Result<void> run_newcomer(const Options& options, const std::function<bool()>& stop) {
  const Result<agents::StateDirectory> state =
      agents::StateDirectory::open(options.state + "/" + name_of(options.first));
  if (!state) return fail(state.error());
  const Result<RobotId> self = state->identity();
  if (!self) return fail(self.error());
  const auto warn = [](const std::string& text) { std::fprintf(stderr, "weft-light-agents: %s\n", text.c_str()); };
  Result<std::optional<bus::Link>> link = open_link(options, *self, stop, warn);
  if (!link) return fail(link.error());
  Random random = agents::random_from_machine();
  const msg::Hello hello = greeting_of(options, *self, random);
  while (link->has_value() && !stop()) {
    if (const Result<std::size_t> sent = (*link)->send(hello); !sent) warn(sent.error().message);
    std::this_thread::sleep_for(kBetweenGreetings);
  }
  return {};
}

}  // namespace weft::light
