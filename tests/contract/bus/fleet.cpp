#include "tests/contract/bus/fleet.hpp"

#include <unistd.h>

#include <chrono>
#include <stdexcept>

namespace weft::contract {
namespace {

constexpr unsigned kDomains = 100;

bus::BusConfig server_config(unsigned domain) {
  bus::BusConfig config;
  config.role = msg::Role::server;
  config.self = kServerId;
  config.domain = domain;
  return config;
}

}  // namespace

std::vector<Pairing> pairings() {
  using bus::Vendor;
  return {{"inprocess", {}, {}},
          {"fastdds", Vendor::fastdds, Vendor::fastdds},
          {"cyclonedds", Vendor::cyclonedds, Vendor::cyclonedds},
          {"fastdds_server_cyclonedds_peer", Vendor::fastdds, Vendor::cyclonedds},
          {"cyclonedds_server_fastdds_peer", Vendor::cyclonedds, Vendor::fastdds}};
}

PeerId peer_id(std::uint8_t number) {
  PeerId id;
  id.bytes.fill(number);
  return id;
}

Fleet::Fleet(Pairing pairing)
    : pairing_(std::move(pairing)), domain_(static_cast<unsigned>(getpid()) % kDomains), net_(Random(1)) {
  net_.set_faults({.delay_min = std::chrono::milliseconds(1), .delay_max = std::chrono::milliseconds(5)});
  start_server();
}

void Fleet::start_server() {
  if (!pairing_.server) {
    server_ = std::make_unique<bus::Link>(net_.attach(msg::Role::server, kServerId));
    return;
  }
  for (unsigned tries = 0; tries < kDomains; ++tries) {
    auto bus = bus::open(*pairing_.server, server_config(domain_));
    if (bus) {
      server_ = std::make_unique<bus::Link>(std::move(*bus));
      return;
    }
    if (bus.error().code != ErrorCode::unavailable) throw std::runtime_error(bus.error().message);
    // Another test may be in the domain: the server's port says so. Peers cannot follow.
    if (!peers_.empty()) throw std::runtime_error(bus.error().message);
    domain_ = (domain_ + 1) % kDomains;
  }
  throw std::runtime_error("no free DDS domain");
}

Peer& Fleet::start_peer(msg::Role role, PeerId id, bool lax) {
  if (!pairing_.peer) return peers_.emplace_back(id, net_.attach(role, id));
  auto bus = RemoteBus::start(
      {.vendor = *pairing_.peer, .role = role, .self = id, .domain = domain_, .server = "127.0.0.1:0", .lax = lax});
  if (!bus) throw std::runtime_error(bus.error().message);
  return peers_.emplace_back(id, std::move(*bus));
}

void Fleet::kill(Peer& peer) {
  if (!pairing_.peer)
    net_.detach(peer.id);
  else
    dynamic_cast<RemoteBus&>(peer.link.bus()).kill();
}

bool Fleet::set_loss(double share) {
  if (pairing_.server) return false;
  net_.set_faults(
      {.loss = share, .delay_min = std::chrono::milliseconds(1), .delay_max = std::chrono::milliseconds(5)});
  return true;
}

void Fleet::let_flow() {
  constexpr Duration kTurn = std::chrono::milliseconds(2);
  if (!pairing_.server)
    net_.deliver_until(virtual_now_ += kTurn);
  else if (server_)
    server_->wait(kTurn);
}

void Fleet::turn() {
  let_flow();
  if (server_) {
    while (auto message = server_->take()) got.push_back(std::move(*message));
  }
  for (Peer& peer : peers_) {
    while (auto message = peer.link.take()) peer.got.push_back(std::move(*message));
  }
}

bool Fleet::until(const std::function<bool()>& holds) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(3);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > limit) return false;
    turn();
  }
  return true;
}

msg::Header header_of(const PeerId& sender) {
  msg::Header header;
  header.sender = sender;
  return header;
}

msg::Hello hello_of(const PeerId& peer, msg::Role role, std::uint64_t incarnation) {
  msg::Hello hello;
  hello.peer = peer;
  hello.role = role;
  hello.incarnation = incarnation;
  return hello;
}

}  // namespace weft::contract
