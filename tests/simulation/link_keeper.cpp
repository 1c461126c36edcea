#include "tests/simulation/link_keeper.hpp"

#include <utility>

namespace weft::simulation {

LinkKeeper::LinkKeeper(bus::InProcessNet& net, const PeerId& self, Whereabouts now_at, SteadyTime now)
    : net_(&net), self_(self) {
  resolve(now_at);
  open(now_at, now);
}

void LinkKeeper::resolve(const Whereabouts& now_at) {
  servers_.clear();
  if (!now_at.server.empty()) servers_.push_back({.ipv4 = now_at.server, .discovery_port = 0});
}

void LinkKeeper::open(const Whereabouts& now_at, SteadyTime now) {
  opened_for_ = {now_at.own, servers_.empty() ? std::string() : servers_.front().ipv4};
  net_->set_open(self_, true);
  std::ignore = keeping_.joined(now, {.listen = now_at.own, .own = {}, .servers = servers_});
}

void LinkKeeper::look(const Whereabouts& now_at, SteadyTime now, std::uint64_t received, Duration unseen) {
  if (std::exchange(has_asked_, false)) resolve(now_at);
  const bus::Keeping::Decision decision = keeping_.next({.now = now,
                                                         .received = received,
                                                         .link = {"simulated", now_at.own, true},
                                                         .servers = servers_,
                                                         .unseen = unseen});
  has_asked_ = decision.asks_resolver;
  if (decision.step == bus::Keeping::Step::join) open(now_at, now);
  if (decision.step != bus::Keeping::Step::leave) return;
  opened_for_.reset();
  net_->set_open(self_, false);
}

}  // namespace weft::simulation
