#include "idl/bus/addresses.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>
#include <utility>

namespace weft::bus {
namespace {

constexpr unsigned kMostDomain = 200;
constexpr unsigned kMostIndex = 119;

class UdpSocket {
 public:
  UdpSocket() : fd_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~UdpSocket() {
    if (fd_ >= 0) close(fd_);
  }
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  /// Tries whether a UDP port is free on an address: returns 0 if it is, else errno. Port 0: any.
  int bind_to(const std::string& ipv4, std::uint16_t port) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_port = htons(port);
    inet_pton(AF_INET, ipv4.c_str(), &at.sin_addr);
    return bind(fd_, reinterpret_cast<const sockaddr*>(&at), sizeof at) == 0 ? 0 : errno;
  }
  std::uint16_t port() const {
    sockaddr_in at{};
    socklen_t size = sizeof at;
    return getsockname(fd_, reinterpret_cast<sockaddr*>(&at), &size) == 0 ? ntohs(at.sin_port) : std::uint16_t{0};
  }

 private:
  int fd_;
};

struct ServerName {
  std::string host;
  unsigned index = 0;
};

Result<ServerName> server_name(const std::string& text) {
  const std::size_t colon = text.find(':');
  ServerName name{text.substr(0, colon), 0};
  if (colon != std::string::npos) {
    const char* const first = text.data() + colon + 1;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(first, last, name.index);
    if (error != std::errc{} || end != last || name.index > kMostIndex) {
      return fail(ErrorCode::invalid, "server '" + text + "' is not HOST or HOST:INDEX with an index of at most " +
                                          std::to_string(kMostIndex));
    }
  }
  if (name.host.empty()) return fail(ErrorCode::invalid, "server '" + text + "' names no host");
  return name;
}

Result<void> check_bound(const BusConfig& config, const std::string& listen, std::uint16_t port) {
  UdpSocket probe;
  const int error = probe.bind_to(listen, port);
  if (error == 0) return {};
  const std::string where = listen + ":" + std::to_string(port);
  if (error == EADDRINUSE) {
    return fail(ErrorCode::unavailable,
                "UDP port " + std::to_string(port) + " on " + listen + " is in use, by another server of domain " +
                    std::to_string(config.domain) + " and index " + std::to_string(config.server_index) +
                    " or by another program (`ss -ulpn` names it): stop it, or take "
                    "another domain or index");
  }
  return fail(ErrorCode::unavailable, "cannot listen on " + where + ": " + std::strerror(error) +
                                          "; give the address of one of this machine's interfaces");
}

}  // namespace

Ports ports_of(unsigned domain, unsigned index) {
  constexpr unsigned kBase = 7400, kDomainGain = 250, kIndexGain = 2, kDiscovery = 10, kData = 11;
  const unsigned block = kBase + kDomainGain * domain + kIndexGain * index;
  return {static_cast<std::uint16_t>(block + kDiscovery), static_cast<std::uint16_t>(block + kData)};
}

Result<std::string> ipv4_of(const std::string& host) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  const int status = getaddrinfo(host.c_str(), nullptr, &hints, &found);
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, freeaddrinfo);
  if (status != 0 || found == nullptr) {
    return fail(ErrorCode::unavailable,
                "host '" + host + "' has no known IPv4 address (" + gai_strerror(status) + "): check the name");
  }
  char text[INET_ADDRSTRLEN] = {};
  inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(found->ai_addr)->sin_addr, text, sizeof text);
  return std::string(text);
}

Result<void> check(const BusConfig& config) {
  if (config.domain > kMostDomain) {
    return fail(ErrorCode::invalid,
                "domain " + std::to_string(config.domain) + " is above " + std::to_string(kMostDomain));
  }
  if (config.server_index > kMostIndex) {
    return fail(ErrorCode::invalid,
                "server_index " + std::to_string(config.server_index) + " is above " + std::to_string(kMostIndex));
  }
  if (config.role != msg::Role::server && config.servers.empty()) {
    return fail(ErrorCode::invalid, "no server is given: agents and clients need its address");
  }
  for (const std::string& text : config.servers) {
    if (const Result<ServerName> name = server_name(text); !name) return fail(name.error());
  }
  return {};
}

Result<std::vector<ServerAddress>> server_addresses(const BusConfig& config) {
  std::vector<ServerAddress> servers;
  for (const std::string& text : config.servers) {
    const Result<ServerName> name = server_name(text);
    if (!name) return fail(name.error());
    Result<std::string> ipv4 = ipv4_of(name->host);
    if (!ipv4) return fail(std::move(ipv4.error()));
    servers.push_back({std::move(*ipv4), ports_of(config.domain, name->index).discovery});
  }
  return servers;
}

Result<Ports> own_ports(const BusConfig& config, const std::string& listen) {
  const bool is_server = config.role == msg::Role::server;
  const Ports fixed = is_server ? ports_of(config.domain, config.server_index) : Ports{};
  for (const std::uint16_t port : {fixed.discovery, fixed.data}) {
    if (const Result<void> bound = check_bound(config, listen, port); !bound) return fail(bound.error());
  }
  if (is_server) return fixed;
  UdpSocket discovery, data;
  if (discovery.bind_to(listen, 0) != 0 || data.bind_to(listen, 0) != 0) {
    return fail(ErrorCode::unavailable, "no free UDP port on " + listen);
  }
  return Ports{discovery.port(), data.port()};
}

bool is_bound(const Addresses& at) {
  UdpSocket probe;
  return probe.bind_to(at.listen, at.own.discovery) == EADDRINUSE;
}

}  // namespace weft::bus
