#include "idl/bus/interfaces.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <memory>
#include <string_view>

#include "idl/bus/addresses.hpp"

namespace weft::bus {
namespace {

using Interfaces = std::unique_ptr<ifaddrs, decltype(&freeifaddrs)>;

Interfaces interfaces() {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) first = nullptr;
  return {first, freeifaddrs};
}

std::string ipv4_text(const ifaddrs& entry) {
  if (entry.ifa_addr == nullptr || entry.ifa_addr->sa_family != AF_INET) return {};
  char text[INET_ADDRSTRLEN] = {};
  inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(entry.ifa_addr)->sin_addr, text, sizeof text);
  return text;
}

bool is_running(const ifaddrs& entry) {
  return (entry.ifa_flags & IFF_UP) != 0 && (entry.ifa_flags & IFF_RUNNING) != 0;
}

LocalLink with_address(const std::string& ipv4) {
  const Interfaces all = interfaces();
  const bool is_loopback = ipv4.starts_with("127.");  // the whole of 127/8 is there, listed or not
  for (const ifaddrs* entry = all.get(); entry != nullptr; entry = entry->ifa_next) {
    const bool is_it = is_loopback ? (entry->ifa_flags & IFF_LOOPBACK) != 0 : ipv4_text(*entry) == ipv4;
    if (is_it) return {entry->ifa_name, ipv4, is_running(*entry)};
  }
  return {};
}

LocalLink with_name(const std::string& name) {
  const Interfaces all = interfaces();
  for (const ifaddrs* entry = all.get(); entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_name != name) continue;
    const std::string ipv4 = ipv4_text(*entry);
    if (!ipv4.empty()) return {name, ipv4, is_running(*entry)};
  }
  return {name, {}, false};
}

}  // namespace

Result<LocalLink> local_link(const std::string& listen) {
  in_addr literal{};
  if (inet_pton(AF_INET, listen.c_str(), &literal) == 1) return with_address(listen);
  if (if_nametoindex(listen.c_str()) != 0) return with_name(listen);
  Result<std::string> host = ipv4_of(listen);
  if (!host) {
    return fail(ErrorCode::unavailable, "'" + listen +
                                            "' is no address, and no interface of this machine has that "
                                            "name: give one of those that `ip -brief address` lists");
  }
  return with_address(*host);
}

Result<void> check_reach(const std::string& listen, const std::string& server_ipv4) {
  const auto is_loopback = [](const std::string& ipv4) { return ipv4.starts_with("127."); };
  if (!is_loopback(listen) || is_loopback(server_ipv4)) return {};
  const Result<LocalLink> here = local_link(server_ipv4);
  if (here && !here->interface.empty()) return {};
  return fail(ErrorCode::unavailable, "it listens on " + listen + ", which reaches this machine alone, and server " +
                                          server_ipv4 +
                                          " is another one: give --listen the address or the name of "
                                          "the interface that leads there (`ip -brief address` lists them)");
}

}  // namespace weft::bus
