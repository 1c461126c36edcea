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

  /// errno, 0 when bound. Port 0: any.
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

Result<ServerAddress> server_address(const std::string& text, unsigned domain) {
  const std::size_t colon = text.find(':');
  unsigned index = 0;
  if (colon != std::string::npos) {
    const char* const first = text.data() + colon + 1;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(first, last, index);
    if (error != std::errc{} || end != last || index > kMostIndex) {
      return fail(ErrorCode::invalid, "server '" + text + "' is not HOST or HOST:INDEX with an index of at most " +
                                          std::to_string(kMostIndex));
    }
  }
  if (text.empty() || colon == 0) return fail(ErrorCode::invalid, "server '" + text + "' names no host");
  Result<std::string> host = ipv4_of(text.substr(0, colon));
  if (!host) return fail(std::move(host.error()));
  return ServerAddress{*host, ports_of(domain, index).discovery};
}

Result<void> check_bound(const BusConfig& config, const std::string& listen, std::uint16_t port) {
  UdpSocket probe;
  const int error = probe.bind_to(listen, port);
  if (error == 0) return {};
  const std::string where = listen + ":" + std::to_string(port);
  if (error == EADDRINUSE) {
    return fail(ErrorCode::unavailable, "UDP port " + std::to_string(port) + " on " + listen +
                                            " is in use: another server of domain " + std::to_string(config.domain) +
                                            " and index " + std::to_string(config.server_index) +
                                            " is running; stop it or take another domain or index");
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

Result<Addresses> look_up(const BusConfig& config) {
  if (config.domain > kMostDomain) {
    return fail(ErrorCode::invalid,
                "domain " + std::to_string(config.domain) + " is above " + std::to_string(kMostDomain));
  }
  if (config.server_index > kMostIndex) {
    return fail(ErrorCode::invalid,
                "server_index " + std::to_string(config.server_index) + " is above " + std::to_string(kMostIndex));
  }
  const bool is_server = config.role == msg::Role::server;
  if (!is_server && config.servers.empty()) {
    return fail(ErrorCode::invalid, "no server is given: agents and clients need its address");
  }
  Result<std::string> listen = ipv4_of(config.listen);
  if (!listen) return fail(std::move(listen.error()));
  Addresses addresses{std::move(*listen), {}, {}};
  UdpSocket discovery, data;
  if (is_server) addresses.own = ports_of(config.domain, config.server_index);
  for (const std::uint16_t port : {addresses.own.discovery, addresses.own.data}) {
    if (Result<void> bound = check_bound(config, addresses.listen, port); !bound)
      return fail(std::move(bound.error()));
  }
  if (!is_server) {
    if (discovery.bind_to(addresses.listen, 0) != 0 || data.bind_to(addresses.listen, 0) != 0) {
      return fail(ErrorCode::unavailable, "no free UDP port on " + addresses.listen);
    }
    addresses.own = {discovery.port(), data.port()};
  }
  for (const std::string& text : config.servers) {
    Result<ServerAddress> server = server_address(text, config.domain);
    if (!server) return fail(std::move(server.error()));
    addresses.servers.push_back(std::move(*server));
  }
  return addresses;
}

}  // namespace weft::bus
