#include "process/systemd.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

namespace weft::process {
namespace {

std::optional<std::int64_t> number(const char* text) {
  const std::string_view digits = text == nullptr ? "" : text;
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

Duration watchdog_of(const char* microseconds, const char* process, std::int64_t self) {
  constexpr std::int64_t kMost = 86'400'000'000;  // a day, which a count of nanoseconds holds
  const std::optional<std::int64_t> after = number(microseconds);
  if (!after || *after <= 0) return {};
  if (process != nullptr && number(process) != self) return {};
  return std::chrono::microseconds(std::min(*after, kMost));
}

ServiceManager ServiceManager::of_environment() {
  return {variable("NOTIFY_SOCKET"),
          watchdog_of(std::getenv("WATCHDOG_USEC"), std::getenv("WATCHDOG_PID"), ::getpid())};
}

ServiceManager::ServiceManager(std::string socket, Duration watchdog)
    : socket_(std::move(socket)), watchdog_(socket_.empty() ? Duration{} : watchdog) {}

void ServiceManager::tell(std::string_view state) const {
  sockaddr_un address{};
  if (socket_.empty() || (socket_[0] != '/' && socket_[0] != '@') || socket_.size() >= sizeof(address.sun_path))
    return;
  address.sun_family = AF_UNIX;
  std::copy(socket_.begin(), socket_.end(), std::begin(address.sun_path));
  if (socket_[0] == '@') address.sun_path[0] = '\0';
  const int file = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (file < 0) return;
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + socket_.size());
  (void)::sendto(file, state.data(), state.size(), MSG_NOSIGNAL | MSG_DONTWAIT,
                 reinterpret_cast<const sockaddr*>(&address), length);
  ::close(file);
}

}  // namespace weft::process
