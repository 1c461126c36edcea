#include "tests/agents/agent/bench.hpp"

#include <gtest/gtest.h>

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

RobotId some_robot() {
  RobotId id;
  id.bytes.fill(7);
  return id;
}

AgentConfig some_config() {
  AgentConfig config;
  config.self = some_robot();
  config.name = "r1";
  config.body = "sim";
  config.can_be_taught_along = true;
  return config;
}
}  // namespace

Bench::Bench()
    : config(some_config()),
      server(some_robot()),
      session(msg::Hello{}, Random(3), now),
      spooler(std::move(*Spooler::open(*spool, SpoolerConfig{}, some_robot(), now))),
      map({}, 1, now),
      refining({*navigator, map, spooler, outbox}, now) {}

void Bench::fetch_map(bool with_contents) {
  for (const SteadyTime end = now + 5s; now < end; now += 250ms) {
    if (const std::optional<msg::WindowRequest> request = map.window_due(now)) {
      for (const msg::Message& answer : server.answer(*request)) {
        map.on_patch(std::get<msg::WindowPatch>(answer), context(), false, now);
      }
    }
    const std::optional<msg::ContentRequest> request = map.contents_due(now);
    if (!request.has_value() || !with_contents) continue;
    for (const msg::Message& answer : server.answer(*request)) map.on_chunk(std::get<msg::Chunk>(answer), now);
  }
}

std::vector<msg::AgentReply> Bench::replied() {
  std::vector<msg::AgentReply> replies_sent;
  for (const msg::Message& message : take().send) {
    if (const auto* const reply = std::get_if<msg::AgentReply>(&message)) replies_sent.push_back(*reply);
  }
  return replies_sent;
}

msg::AgentReply Bench::only_reply() {
  const std::vector<msg::AgentReply> all = replied();
  EXPECT_EQ(all.size(), 1U);
  return all.size() == 1 ? all.front() : msg::AgentReply{};
}

}  // namespace weft::agents::test
