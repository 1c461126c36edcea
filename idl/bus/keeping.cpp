#include "idl/bus/keeping.hpp"

#include <algorithm>
#include <utility>

namespace weft::bus {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenTries = 1s;
constexpr Duration kBetweenNotices = 30s;
constexpr Duration kSettles = 1s;   ///< an address that is taken away and given back in between has not changed
constexpr Duration kDoubtful = 3s;  ///< of silence: asks the resolver whether the server has moved
constexpr Duration kBetweenAsking = 2s;
constexpr Duration kSilent = 8s;  ///< longer than a server is silent that has nothing to say
constexpr Duration kMostPatience = 60s;
/// Bounds how long this process may stand still and keep its link: others forget a participant after
/// kParticipantLease, counted from an announcement that may have been a second ago.
constexpr Duration kForgotten = 3500ms;

std::string why_deaf(const LocalLink& link, const std::string& listen) {
  if (link.interface.empty()) return "no interface has the address " + listen;
  if (link.ipv4.empty()) return "interface " + link.interface + " has no IPv4 address";
  return "interface " + link.interface + " (" + link.ipv4 + ") is down or has no carrier";
}

std::string address_text(const std::vector<ServerAddress>& servers) {
  std::string text;
  for (const ServerAddress& server : servers) text += (text.empty() ? "" : ", ") + server.ipv4;
  return text;
}

}  // namespace

Keeping::Decision Keeping::next(const Sight& sight) {
  if (sight.received != std::exchange(received_, sight.received)) {
    heard_at_ = sight.now;
    patience_ = kSilent;
  }
  if (at_.has_value() && sight.unseen >= kForgotten) {
    return leave(sight.now,
                 "it stood still for " +
                     std::to_string(std::chrono::duration_cast<std::chrono::seconds>(sight.unseen).count()) +
                     " s, and others may have forgotten it: opens its link anew");
  }
  if (at_.has_value() && sight.is_unanswered && sight.link.carries)
    return leave(sight.now, "is not answered: opens its link anew");
  return at_.has_value() ? inside(sight) : outside(sight);
}

Keeping::Decision Keeping::outside(const Sight& sight) {
  if (!sight.link.carries) {
    return {.notice = said(sight.now, "waits for its link: " + why_deaf(sight.link, listen_))};
  }
  Decision decision;
  decision.asks_resolver = !sight.servers && sight.now >= ask_at_;
  if (decision.asks_resolver) ask_at_ = sight.now + kBetweenAsking;
  if (sight.servers && sight.now >= join_at_) {
    decision.step = Step::join;
  } else if (!why_not_.empty()) {
    decision.notice = said(sight.now, "cannot open its link, tries on: " + why_not_);
  } else if (!sight.servers && !decision.asks_resolver) {
    decision.notice = said(sight.now, "waits for the address of its server: its name is not known yet");
  }
  return decision;
}

Keeping::Decision Keeping::inside(const Sight& sight) {
  const SteadyTime now = sight.now;
  if (sight.link.ipv4 != at_->listen) {
    if (!changed_since_) changed_since_ = now;
    if (now - *changed_since_ < kSettles) return {};
    const std::string is_now =
        sight.link.ipv4.empty() ? why_deaf(sight.link, listen_) : sight.link.interface + " has " + sight.link.ipv4;
    return leave(now, "its address " + at_->listen + " is gone, " + is_now + ": opens its link anew");
  }
  changed_since_.reset();
  // A server hears nothing of a fleet that is switched off; and what has lost its carrier comes back by itself.
  if (at_->servers.empty() || !sight.link.carries) return {};
  const Duration silence = now - std::max(heard_at_, joined_at_);
  if (silence < kDoubtful) return {};
  if (sight.servers && *sight.servers != at_->servers) {
    return leave(now, "its server is at " + address_text(*sight.servers) + " now, no longer at " +
                          address_text(at_->servers) + ": opens its link anew");
  }
  if (silence >= patience_) {
    patience_ = std::min(2 * patience_, kMostPatience);
    return leave(now, "");
  }
  Decision decision;
  decision.asks_resolver = now >= ask_at_;
  if (decision.asks_resolver) ask_at_ = now + kBetweenAsking;
  return decision;
}

Keeping::Decision Keeping::leave(SteadyTime now, std::string why) {
  at_.reset();
  changed_since_.reset();
  join_at_ = now;
  why_not_.clear();
  said_ = why;
  return {.step = Step::leave, .notice = std::move(why)};
}

std::string Keeping::joined(SteadyTime now, const Addresses& at) {
  at_ = at;
  joined_at_ = now;
  patience_ = std::max(patience_, kSilent);
  why_not_.clear();
  return std::exchange(said_, {}).empty() ? std::string() : "its link is open on " + at.listen;
}

void Keeping::failed(SteadyTime now, const std::string& why) {
  why_not_ = why;
  join_at_ = now + kBetweenTries;
}

std::string Keeping::said(SteadyTime now, std::string text) {
  if (text == said_ && now < say_at_) return {};
  said_ = text;
  say_at_ = now + kBetweenNotices;
  return text;
}

}  // namespace weft::bus
