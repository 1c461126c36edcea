#include "server/fleet/skew.hpp"

#include <algorithm>

namespace weft::server {

void ClockSkew::sent(std::uint64_t probe, SteadyTime now) {
  pending_[next_pending_] = {.probe = probe, .sent = now};
  next_pending_ = (next_pending_ + 1) % pending_.size();
}

void ClockSkew::answered(const msg::ClockReply& reply, Now now) {
  const auto found = std::find_if(pending_.begin(), pending_.end(),
                                  [&](const Pending& pending) { return pending.probe == reply.probe; });
  if (found == pending_.end() || reply.probe == 0) return;
  const Duration away = now.steady - found->sent;
  const Duration there = reply.replied - reply.received;
  found->probe = 0;  // a doubled reply counts once
  samples_[sample_count_++ % samples_.size()] = {
      .round_trip = away - there, .ahead = ((reply.received - reply.probe_sent) + (reply.replied - now.wall)) / 2};
}

std::optional<double> ClockSkew::seconds_ahead() const {
  if (sample_count_ == 0) return std::nullopt;
  const auto* const end = samples_.begin() + static_cast<std::ptrdiff_t>(std::min(sample_count_, samples_.size()));
  const auto* const best = std::min_element(
      samples_.begin(), end, [](const Sample& a, const Sample& b) { return a.round_trip < b.round_trip; });
  return seconds(best->ahead);
}

}  // namespace weft::server
