#include "server/fleet/incarnations.hpp"

#include <algorithm>
#include <chrono>

namespace weft::server {
namespace {
using namespace std::chrono_literals;

/// Bounds how long a message is on its way; one that comes later was sent by somebody alive.
constexpr Duration kLongestWay = 3s;
constexpr int kStrikes = 2;
constexpr std::size_t kRemembered = 4;
}  // namespace

Incarnations::Known* Incarnations::find(std::uint64_t incarnation) {
  const auto found = std::find_if(known_.begin(), known_.end(),
                                  [&](const Known& known) { return known.incarnation == incarnation; });
  return found == known_.end() ? nullptr : &*found;
}

Incarnations::Verdict Incarnations::hear(std::uint64_t incarnation, SteadyTime now) {
  Known* const known = find(incarnation);
  if (known == nullptr) {
    const bool is_first = known_.empty();
    if (known_.size() == kRemembered) known_.erase(known_.begin());
    known_.push_back({.incarnation = incarnation, .heard = now});
    current_ = incarnation;
    since_ = now;
    if (is_first) return Verdict::first;
    return twins_ ? Verdict::twin : Verdict::fresh;
  }
  known->heard = now;
  if (!twins_ && incarnation != current_ && now - since_ > kLongestWay && ++known->strikes >= kStrikes) {
    twins_ = true;
  }
  if (twins_) return Verdict::twin;
  return incarnation == current_ ? Verdict::current : Verdict::late;
}

bool Incarnations::settle(SteadyTime now, Duration quiet) {
  if (!twins_) return false;
  const Known* alive = nullptr;
  for (const Known& known : known_) {
    if (now - known.heard > quiet) continue;
    if (alive != nullptr) return false;
    alive = &known;
  }
  if (alive == nullptr) return false;
  const Known survivor = {.incarnation = alive->incarnation, .heard = alive->heard};
  known_ = {survivor};
  current_ = survivor.incarnation;
  since_ = now;
  twins_ = false;
  return true;
}

void Incarnations::excuse(Duration away, SteadyTime now) {
  for (Known& known : known_) known.heard = std::min(known.heard + away, now);
  since_ = std::min(since_ + away, now);
}

}  // namespace weft::server
