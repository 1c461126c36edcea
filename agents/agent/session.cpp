#include "agents/agent/session.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kHelloUnheard = 2s;
constexpr Duration kHelloHeard = 15s;
/// Sets how soon a hello is said again while somebody claims to be the server: one may be lost on the way.
constexpr Duration kHelloAsking = 500ms;
constexpr Duration kConfirmedWithin = 3s;
constexpr std::size_t kMostClaims = 4;
/// Bounds the fence: a server that has nothing to answer (an empty network) would leave it open for ever.
constexpr Duration kFenceAtMost = 3s;
}  // namespace

Session::Session(msg::Hello own, Random random, SteadyTime now)
    : own_(std::move(own)), random_(random), started_(now), next_hello_(now), silence_(now) {
  own_.challenge = random_.next() | 1U;
}

Session::Heard Session::hear(const msg::Hello& hello, SteadyTime now) {
  const Speaker who{hello.epoch, hello.incarnation};
  const bool is_confirmed = answers(hello);
  if (hello.protocol_min <= own_.protocol_max && hello.protocol_max >= own_.protocol_min) {
    const Heard heard = hear(who, is_confirmed, now);
    if (heard != Heard::refused) incompatible_.clear();
    return heard;
  }
  ++counters_["hello: no protocol version in common"];
  if (heard_server() && !is_server(who) && !is_confirmed) {
    if (who.epoch > epoch_) claim(who, now);
    return Heard::refused;
  }
  incompatible_ = "the server speaks protocol " + std::to_string(hello.protocol_min) + " to " +
                  std::to_string(hello.protocol_max) + ", this agent " + std::to_string(own_.protocol_min) + " to " +
                  std::to_string(own_.protocol_max) + ": update the older one";
  return Heard::refused;
}

Session::Heard Session::hear(const msg::Header& header, SteadyTime now) {
  return hear({header.epoch, header.incarnation}, false, now);
}

Session::Heard Session::hear(const Speaker& who, bool is_confirmed, SteadyTime now) {
  if (is_server(who)) {
    silence_.hear(now);
    return Heard::known;
  }
  if (who.epoch < epoch_) {
    ++counters_["server: epoch lower than heard before"];
    return Heard::refused;
  }
  if (who.epoch == epoch_ && heard_server()) {
    ++counters_["server: a second one in the same epoch"];
    return Heard::refused;
  }
  if (!is_confirmed) {
    claim(who, now);
    return Heard::refused;
  }
  silence_.hear(now);
  epoch_ = who.epoch;
  server_incarnation_ = who.incarnation;
  std::erase_if(claims_, [&](const Claim& other) { return other.who.epoch <= epoch_; });
  next_hello_ = now + (claims_.empty() ? kHelloHeard : kHelloAsking);
  return Heard::restarted;
}

bool Session::is_server(const Speaker& who) const {
  return server_incarnation_ == who.incarnation && epoch_ == who.epoch;
}

bool Session::answers(const msg::Hello& hello) const {
  // Without a claim the number is one that was answered before.
  if (heard_server() && claims_.empty()) return false;
  return std::find(hello.answers.begin(), hello.answers.end(), own_.challenge) != hello.answers.end();
}

void Session::claim(const Speaker& who, SteadyTime now) {
  const auto known =
      std::find_if(claims_.begin(), claims_.end(), [&](const Claim& claim) { return claim.who == who; });
  if (known != claims_.end()) return;
  ++counters_["server: claims to be it, not confirmed yet"];
  if (claims_.empty() && heard_server()) own_.challenge = random_.next() | 1U;
  if (claims_.size() == kMostClaims) claims_.erase(claims_.begin());
  claims_.push_back({who, now + kConfirmedWithin});
  next_hello_ = now;
}

std::vector<std::string> Session::drop_claims(SteadyTime now) {
  std::vector<std::string> said;
  std::erase_if(claims_, [&](const Claim& claim) {
    if (claim.until > now) return false;
    ++counters_["server: a claim that nobody confirmed"];
    said.push_back(
        "somebody spoke as a server in epoch " + std::to_string(claim.who.epoch.value) +
        " and did not answer when asked: not believed" +
        (heard_server() ? "; the server is still the one in epoch " + std::to_string(epoch_.value) : std::string()));
    return true;
  });
  return said;
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
  next_hello_ = now + (!claims_.empty() ? kHelloAsking : heard_server() ? kHelloHeard : kHelloUnheard);
  return own_;
}

SteadyTime Session::next() const {
  SteadyTime next = next_hello_;
  for (const Claim& claim : claims_) next = std::min(next, claim.until);
  return next;
}

void Session::was_away(Duration away, SteadyTime now) {
  started_ = std::min(started_ + away, now);
  silence_.was_away(away, now);
  for (Claim& claim : claims_) claim.until += away;
}

}  // namespace weft::agents
