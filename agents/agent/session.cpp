#include "agents/agent/session.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kHelloUnheard = 2s;
constexpr Duration kHelloHeard = 15s;
/// A server that has nothing to answer (an empty network) would leave the fence open for ever.
constexpr Duration kFenceAtMost = 3s;
}  // namespace

Session::Session(msg::Hello own, SteadyTime now) : own_(std::move(own)), started_(now), next_hello_(now) {}

Session::Heard Session::hear(const msg::Hello& hello, SteadyTime now) {
  if (hello.protocol_min > own_.protocol_max || hello.protocol_max < own_.protocol_min) {
    incompatible_ = "the server speaks protocol " + std::to_string(hello.protocol_min) + " to " +
                    std::to_string(hello.protocol_max) + ", this agent " + std::to_string(own_.protocol_min) +
                    " to " + std::to_string(own_.protocol_max) + ": update the older one";
    ++counters_["hello: no protocol version in common"];
    return Heard::refused;
  }
  const Heard heard = hear(hello.epoch, hello.incarnation, now);
  if (heard != Heard::refused) incompatible_.clear();
  return heard;
}

Session::Heard Session::hear(const msg::Header& header, SteadyTime now) {
  return hear(header.epoch, header.incarnation, now);
}

Session::Heard Session::hear(Epoch epoch, std::uint64_t incarnation, SteadyTime now) {
  if (epoch < epoch_) {
    ++counters_["server: epoch lower than heard before"];
    return Heard::refused;
  }
  if (epoch == epoch_ && server_incarnation_.has_value()) {
    if (*server_incarnation_ == incarnation) return Heard::known;
    ++counters_["server: a second one in the same epoch"];
    return Heard::refused;
  }
  epoch_ = epoch;
  server_incarnation_ = incarnation;
  next_hello_ = now;
  return Heard::restarted;
}

void Session::answered(const msg::Header& header) {
  if (!fence_.has_value()) fence_ = Fence{header.epoch, header.sequence};
}

bool Session::is_meant_for_me(const msg::Header& header, SteadyTime now) const {
  if (!fence_.has_value()) return now - started_ >= kFenceAtMost;
  return header.epoch > fence_->epoch || header.sequence >= fence_->sequence;
}

msg::Header Session::header() {
  return {.sender = own_.peer,
          .incarnation = own_.incarnation,
          .epoch = epoch_,
          .sequence = ++sequence_,
          .signature = {}};
}

std::optional<msg::Hello> Session::due(SteadyTime now) {
  if (now < next_hello_) return std::nullopt;
  next_hello_ = now + (heard_server() ? kHelloHeard : kHelloUnheard);
  return own_;
}

void Session::was_away(Duration away, SteadyTime now) {
  started_ = std::min(started_ + away, now);
}

}  // namespace weft::agents
