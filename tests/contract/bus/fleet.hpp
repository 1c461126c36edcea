#pragma once
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "idl/bus/inprocess/net.hpp"
#include "idl/bus/link.hpp"
#include "tests/contract/bus/remote_bus.hpp"

namespace weft::contract {

/// Names one of the buses, or a mix: who the server speaks through and who its peers.
struct Pairing {
  std::string name;
  std::optional<bus::Vendor> server;  ///< none: in process, both
  std::optional<bus::Vendor> peer;

  friend void PrintTo(const Pairing& pairing, std::ostream* out) { *out << pairing.name; }
};
std::vector<Pairing> pairings();

PeerId peer_id(std::uint8_t number);
inline const PeerId kServerId = peer_id(1);

/// Holds a peer of the server: over DDS a process of its own.
class Peer {
 public:
  Peer(PeerId self, std::unique_ptr<bus::Bus> bus) : id(self), link(std::move(bus)) {}
  const PeerId id;
  bus::Link link;
  std::vector<msg::Message> got;
};

/// Holds a server in this process and its peers on a pairing's buses, in a DDS domain of its own.
class Fleet {
 public:
  explicit Fleet(Pairing pairing);

  bus::Link& server() { return *server_; }
  Peer& start_peer(msg::Role role, PeerId id, bool lax = false);
  /// Kills the peer with kill -9, or what comes closest in process.
  void kill(Peer& peer);
  void stop_server() { server_.reset(); }
  /// Starts the server anew: same address, nothing remembered.
  void start_server();
  /// Sets the loss, where messages can be lost at will; elsewhere returns false.
  bool set_loss(double share);

  /// Asks whether it `holds`, and if not turns, again and again. False after a minute of that.
  bool until(const std::function<bool()>& holds);
  /// Lets messages flow for a moment and collects them.
  void turn();
  /// Lets messages flow without collecting them: for tests that take from the buses themselves.
  void let_flow();

  std::vector<msg::Message> got;  ///< by the server

  template <class M>
  static std::vector<M> all(const std::vector<msg::Message>& messages) {
    std::vector<M> found;
    for (const msg::Message& message : messages) {
      if (const M* const one = std::get_if<M>(&message)) found.push_back(*one);
    }
    return found;
  }

 private:
  Pairing pairing_;
  unsigned domain_ = 0;
  bus::InProcessNet net_;
  SteadyTime virtual_now_{};
  std::unique_ptr<bus::Link> server_;
  std::list<Peer> peers_;
};

msg::Header header_of(const PeerId& sender);
msg::Hello hello_of(const PeerId& peer, msg::Role role, std::uint64_t incarnation = 1);

}  // namespace weft::contract
