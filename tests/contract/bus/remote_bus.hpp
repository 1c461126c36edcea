#pragma once
#include <sys/types.h>

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "idl/bus/bus.hpp"
#include "tests/contract/bus/frames.hpp"

namespace weft::contract {

/// Speaks for a bus that lives in a process of its own (weft-bus-peer): to be killed for real, and because Cyclone
/// DDS takes one bus a domain and process. Blocks on the pipe; killed, it fails and is silent.
class RemoteBus final : public bus::Bus {
 public:
  struct Options {
    bus::Vendor vendor{};
    msg::Role role{};
    PeerId self;
    unsigned domain = 0;
    std::string listen = "127.0.0.1";
    std::string server{};  ///< a server has none
    bool lax = false;      ///< sends what the table's bounds forbid
    pid_t network_of = 0;  ///< lives in the network namespace of this process; 0: in this one's
    std::string hosts{};   ///< a file that it sees as /etc/hosts; empty: the system's
  };
  static Result<std::unique_ptr<RemoteBus>> start(const Options& options);
  ~RemoteBus() override;
  RemoteBus(const RemoteBus&) = delete;
  RemoteBus& operator=(const RemoteBus&) = delete;

  /// Kills the process with kill -9.
  void kill();

  Result<void> publish(bus::TopicId topic, const PeerId& to, ByteView cdr) override;
  std::optional<bus::Delivery> take() override;
  bool wait(Duration at_most) override;
  void wake() override {}
  std::string vendor() const override { return vendor_; }
  msg::Role role() const override { return role_; }
  bus::BusCounters counters() const override;
  void forget(const PeerId& peer) override;

 private:
  RemoteBus(pid_t child, int to_child, int from_child, const Options& options);
  /// Sends an order and returns its answer; what is delivered meanwhile waits in the inbox.
  std::optional<Frame> ask(const Frame& order) const;

  pid_t child_;
  int to_child_;
  int from_child_;
  std::string vendor_;
  msg::Role role_;
  mutable std::deque<bus::Delivery> inbox_;
};

}  // namespace weft::contract
