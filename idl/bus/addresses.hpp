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
};

/// Everything about addresses that a backend needs, looked up and checked.
struct Addresses {
  std::string listen;  ///< dotted, of a local interface
  Ports own;           ///< the server's fixed ones; free ones for others
  std::vector<ServerAddress> servers;
};
/// invalid: a bound of BusConfig, a server's text. unavailable: no local interface has the address, a host is not
/// known, or the server's port is in use; the message names it and says what to do.
Result<Addresses> look_up(const BusConfig& config);

}  // namespace weft::bus
