#pragma once
#include <string>

#include "core/result.hpp"

namespace weft::bus {

/// Describes an interface of this machine as it is now.
struct LocalLink {
  std::string interface;  ///< its name; empty: no interface has the address
  std::string ipv4;       ///< dotted; empty: the interface has none
  bool carries = false;   ///< up, with carrier and address: sockets that are bound to it hear and are heard

  friend bool operator==(const LocalLink&, const LocalLink&) = default;
};

/// Finds the interface that `listen` means: an IPv4 address of it, its name, or a host name for its address.
/// unavailable: `listen` is a name that neither an interface nor a host has.
Result<LocalLink> local_link(const std::string& listen);

/// Refuses a server on another machine for who listens on this machine's loopback address alone, the default of
/// --listen.
Result<void> check_reach(const std::string& listen, const std::string& server_ipv4);

}  // namespace weft::bus
