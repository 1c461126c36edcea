#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "idl/bus/bus.hpp"

namespace weft::bus {

/// Holds a participant's two UDP ports.
struct Ports {
  std::uint16_t discovery = 0;
  std::uint16_t data = 0;
};
/// Returns a participant's ports by the rule of RTPS 2.5, 9.6.2.3, for domains [0, 200] and indices [0, 119].
Ports ports_of(unsigned domain, unsigned index);

struct ServerAddress {
  std::string ipv4;
  std::uint16_t discovery_port = 0;

  friend bool operator==(const ServerAddress&, const ServerAddress&) = default;
};

/// Holds every address that a backend needs, looked up and checked.
struct Addresses {
  std::string listen;  ///< dotted, of a local interface
  Ports own;           ///< the server's fixed ones; free ones for others
  std::vector<ServerAddress> servers;
};

/// Checks a configuration. invalid: names its broken bound, or the server's text that is no HOST or HOST:INDEX.
Result<void> check(const BusConfig& config);
/// Returns the first IPv4 address of a host. Asks the system's resolver, which may take many seconds. unavailable:
/// none is known.
Result<std::string> ipv4_of(const std::string& host);
/// Returns where the servers of a checked configuration are. Asks the resolver as ipv4_of() does, with its errors.
Result<std::vector<ServerAddress>> server_addresses(const BusConfig& config);
/// Returns this process's ports. unavailable: the server's is in use or the address cannot be bound; says what to do.
Result<Ports> own_ports(const BusConfig& config, const std::string& listen);
/// Returns whether a socket is bound to the port that others are told to discover this process at.
bool is_bound(const Addresses& at);

}  // namespace weft::bus
