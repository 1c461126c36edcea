#pragma once
#include <array>
#include <compare>
#include <deque>
#include <map>
#include <queue>
#include <tuple>
#include <vector>

#include "idl/bus/inprocess/net.hpp"
#include "idl/bus/topics.hpp"

namespace weft::bus {

/// Holds what the network knows of one peer that is up. `life` tells a peer from its earlier selves, `link` its link
/// from those that it had open before.
struct Endpoint {
  msg::Role role = msg::Role::agent;
  std::uint64_t life = 0;
  std::uint64_t link = 0;
  bool is_open = true;
  std::deque<Delivery> inbox;
  BusCounters counters;
};

class InProcessNet::State {
 public:
  explicit State(Random random) : random_(random) {}

  std::uint64_t attach(msg::Role role, const PeerId& self);
  void detach(const PeerId& peer);
  void partition(const PeerId& peer, Cut cut);
  void set_open(const PeerId& peer, bool is_open);
  void set_faults(const Faults& faults) { faults_ = faults; }
  void set_now(SteadyTime now) { now_ = std::max(now_, now); }
  std::optional<SteadyTime> next_delivery() const;
  void deliver_until(SteadyTime now);
  void publish(const PeerId& from, const Topic& topic, const PeerId& to, ByteView cdr);
  /// Returns the peer's end of the network; null when that life of the peer is over.
  Endpoint* endpoint(const PeerId& peer, std::uint64_t life);

 private:
  using Key = std::array<std::uint8_t, 16>;
  struct Retained {
    PeerId writer;
    TopicId topic{};
    Key key{};
    auto operator<=>(const Retained&) const = default;
  };
  struct UnderWay {
    SteadyTime due{};
    std::uint64_t number = 0;  ///< order of sending: ties in time
    PeerId from, to;
    std::uint64_t from_link = 0, to_link = 0;
    TopicId topic{};
    std::shared_ptr<const Bytes> cdr;
  };
  struct Later {
    bool operator()(const UnderWay& a, const UnderWay& b) const {
      return std::tie(a.due, a.number) > std::tie(b.due, b.number);
    }
  };
  /// Names one direction between two peers; bulk has a lane of its own.
  struct LaneId {
    PeerId from, to;
    bool bulk = false;
    auto operator<=>(const LaneId&) const = default;
  };
  struct Lane {
    SteadyTime busy_until{};
    SteadyTime last_due{};
  };

  void send(const PeerId& from, const PeerId& to, const Topic& topic, const std::shared_ptr<const Bytes>& cdr);
  void put_under_way(UnderWay message, Lane& lane);
  void send_retained(const PeerId& writer, const PeerId& reader);
  Endpoint* over(const PeerId& peer, std::uint64_t link);
  void deliver(const UnderWay& message);
  Cut cut_of(const PeerId& peer) const;
  bool passes(const PeerId& from, const PeerId& to) const;

  Random random_;
  Faults faults_;
  SteadyTime now_{};
  std::uint64_t lives_ = 0;
  std::uint64_t links_ = 0;
  std::uint64_t sent_ = 0;
  std::map<PeerId, Endpoint> endpoints_;
  std::map<PeerId, Cut> cut_;  ///< links that are cut
  std::map<Retained, std::shared_ptr<const Bytes>> retained_;
  std::map<LaneId, Lane> lanes_;
  std::priority_queue<UnderWay, std::vector<UnderWay>, Later> under_way_;
};

}  // namespace weft::bus
