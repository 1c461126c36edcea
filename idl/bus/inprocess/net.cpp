#include "idl/bus/inprocess/net.hpp"

#include "idl/bus/inprocess/state.hpp"

namespace weft::bus {

/// Serves one life of one peer. After `detach` it sends and receives nothing.
class InProcessBus final : public Bus {
 public:
  InProcessBus(std::shared_ptr<InProcessNet::State> net, msg::Role role, const PeerId& self, std::uint64_t life)
      : net_(std::move(net)), role_(role), self_(self), life_(life) {}
  ~InProcessBus() override {
    if (net_->endpoint(self_, life_) != nullptr) net_->detach(self_);
  }
  InProcessBus(const InProcessBus&) = delete;
  InProcessBus& operator=(const InProcessBus&) = delete;

  Result<void> publish(TopicId id, const PeerId& to, ByteView cdr) override;
  std::optional<Delivery> take() override;
  bool wait(Duration) override {
    const Endpoint* const own = net_->endpoint(self_, life_);
    return own != nullptr && !own->inbox.empty();
  }
  void wake() override {}
  std::string vendor() const override { return "inprocess"; }
  msg::Role role() const override { return role_; }
  BusCounters counters() const override {
    const Endpoint* const own = net_->endpoint(self_, life_);
    return own == nullptr ? BusCounters{} : own->counters;
  }
  void forget(const PeerId&) override {}
  bool is_open() const override {
    const Endpoint* const own = net_->endpoint(self_, life_);
    return own != nullptr && own->is_open;
  }

 private:
  std::shared_ptr<InProcessNet::State> net_;
  msg::Role role_;
  PeerId self_;
  std::uint64_t life_;
};

Result<void> InProcessBus::publish(TopicId id, const PeerId& to, ByteView cdr) {
  Endpoint* const own = net_->endpoint(self_, life_);
  if (own == nullptr) {
    return fail(ErrorCode::unavailable, "this bus is detached from its network: open another one");
  }
  const Topic& topic = bus::topic(id);
  if (const Result<void> may = check_publish(topic, role_, to, cdr); !may) {
    ++(cdr.size() > topic.max_bytes ? own->counters.refused_size : own->counters.publish_failed);
    return may;
  }
  if (!own->is_open && topic.delivering != Delivering::state) {
    ++own->counters.publish_failed;
    return fail(ErrorCode::unavailable, std::string(topic.name) + ": the link is not open; try again later");
  }
  net_->publish(self_, topic, to, cdr);
  ++own->counters.sent;
  return {};
}

std::optional<Delivery> InProcessBus::take() {
  Endpoint* const own = net_->endpoint(self_, life_);
  if (own == nullptr || own->inbox.empty()) return std::nullopt;
  Delivery first = std::move(own->inbox.front());
  own->inbox.pop_front();
  return first;
}

InProcessNet::InProcessNet(Random random) : state_(std::make_shared<State>(random)) {}
InProcessNet::InProcessNet(InProcessNet&&) noexcept = default;
InProcessNet& InProcessNet::operator=(InProcessNet&&) noexcept = default;
InProcessNet::~InProcessNet() = default;

std::unique_ptr<Bus> InProcessNet::attach(msg::Role role, const PeerId& self) {
  const std::uint64_t life = state_->attach(role, self);
  return std::make_unique<InProcessBus>(state_, role, self, life);
}
void InProcessNet::detach(const PeerId& peer) {
  state_->detach(peer);
}
void InProcessNet::partition(const PeerId& peer, Cut cut) {
  state_->partition(peer, cut);
}
void InProcessNet::set_open(const PeerId& peer, bool is_open) {
  state_->set_open(peer, is_open);
}
void InProcessNet::set_faults(const Faults& faults) {
  state_->set_faults(faults);
}
void InProcessNet::set_now(SteadyTime now) {
  state_->set_now(now);
}
std::optional<SteadyTime> InProcessNet::next_delivery() const {
  return state_->next_delivery();
}
void InProcessNet::deliver_until(SteadyTime now) {
  state_->deliver_until(now);
}

}  // namespace weft::bus
