#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "idl/bus/bus.hpp"

namespace weft::bus {

/// A participant's two UDP ports.
struct Ports {
  std::uint16_t discovery = 0;
  std::uint16_t data = 0;
};
/// By the rule of RTPS 2.5, 9.6.2.3, for domains [0, 200] and indices [0, 119].
Ports ports_of(unsigned domain, unsigned index);

struct ServerAddress {
  std::string ipv4;
  std::uint16_t discovery_port = 0;

  friend bool operator==(const ServerAddress&, const ServerAddress&) = default;
};

/// Everything about addresses that a backend needs, looked up and checked.
struct Addresses {
  std::string listen;  ///< dotted, of a local interface
  Ports own;           ///< the server's fixed ones; free ones for others
  std::vector<ServerAddress> servers;
};

/// invalid: names the bound of BusConfig that is broken, or the server's text that is no HOST or HOST:INDEX.
Result<void> check(const BusConfig& config);
/// The first IPv4 address of a host. Asks the system's resolver, which may take many seconds. unavailable: none is
/// known.
Result<std::string> ipv4_of(const std::string& host);
/// Where the servers of a checked configuration are, asked in the same way.
Result<std::vector<ServerAddress>> server_addresses(const BusConfig& config);
/// unavailable: the server's port is in use, or the address cannot be bound; says what to do.
Result<Ports> own_ports(const BusConfig& config, const std::string& listen);

}  // namespace weft::bus
