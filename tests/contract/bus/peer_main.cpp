#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <deque>
#include <mutex>
#include <thread>

#include "idl/bus/backends.hpp"
#include "tests/contract/bus/frames.hpp"

/// Runs a bus in a process of its own, driven over stdin and stdout by the contract tests' RemoteBus:
/// weft-bus-peer VENDOR ROLE HEX_ID DOMAIN LISTEN SERVER strict|lax PROCESS HOSTS. `lax` sends what the topic table's
/// bounds forbid. PROCESS: in whose network namespace it lives, 0 for the one that it is started in. HOSTS: its
/// /etc/hosts, or nothing.
namespace weft::contract {
namespace {

using bus::Bus;

enum Argument : std::uint8_t {
  program,
  vendor,
  role,
  id,
  domain,
  listen,
  server,
  bounds,
  process,
  hosts,
  arguments_in_all
};

msg::Role role_from(std::string_view text) {
  if (text == "server") return msg::Role::server;
  return text == "client" ? msg::Role::client : msg::Role::agent;
}

bus::BusConfig config_from(char** arguments) {
  bus::BusConfig config;
  config.role = role_from(arguments[role]);
  parse_hex(arguments[id], config.self.bytes.data(), config.self.bytes.size());
  config.domain = static_cast<unsigned>(std::strtoul(arguments[domain], nullptr, 10));
  config.listen = arguments[listen];
  if (arguments[server][0] != '\0') config.servers = {arguments[server]};
  return config;
}

bool enter_network_of(const std::string& process) {
  if (process == "0") return true;
  const int network = open(("/proc/" + process + "/ns/net").c_str(), O_RDONLY | O_CLOEXEC);
  return network >= 0 && setns(network, CLONE_NEWNET) == 0;
}

/// Replaces the file of host names for this process alone.
bool take_hosts_from(const char* file) {
  return *file == '\0' ||
         (unshare(CLONE_NEWNS) == 0 && mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
          mount(file, "/etc/hosts", nullptr, MS_BIND, nullptr) == 0);
}

Result<std::unique_ptr<Bus>> open_from(char** arguments) {
  std::array<bus::Topic, bus::kTopics> table{};
  std::copy(bus::topics().begin(), bus::topics().end(), table.begin());
  constexpr std::uint32_t kLax = 16;
  if (std::strcmp(arguments[bounds], "lax") == 0) {
    for (bus::Topic& topic : table) topic.max_bytes *= kLax;
  }
  const bus::BusConfig config = config_from(arguments);
  const bus::Vendor by =
      std::strcmp(arguments[vendor], "fastdds") == 0 ? bus::Vendor::fastdds : bus::Vendor::cyclonedds;
  return bus::open(by, config, table);
}

Frame answer(Bus& bus, const Frame& frame) {
  if (frame.op == Op::forget) {
    bus.forget(frame.peer);
    return {Op::result, kNoError, {}, {}};
  }
  if (frame.op == Op::ask_counters) {
    const bus::BusCounters counters = bus.counters();
    Frame reply{Op::counters, 0, {}, Bytes(sizeof counters)};
    std::memcpy(reply.bytes.data(), &counters, sizeof counters);
    return reply;
  }
  const Result<void> done = bus.publish(bus::TopicId{frame.number}, frame.peer, frame.bytes);
  if (done) return {Op::result, kNoError, {}, {}};
  return {Op::result, static_cast<std::uint8_t>(done.error().code), {}, bytes_of(done.error().message)};
}

/// Takes orders that come in on a thread of their own; the bus belongs to the main thread.
class Orders {
 public:
  void put(Frame frame) {
    const std::lock_guard lock(mutex_);
    frames_.push_back(std::move(frame));
  }
  std::optional<Frame> take() {
    const std::lock_guard lock(mutex_);
    if (frames_.empty()) return std::nullopt;
    Frame first = std::move(frames_.front());
    frames_.pop_front();
    return first;
  }

 private:
  std::mutex mutex_;
  std::deque<Frame> frames_;
};

void relay(Bus& bus) {
  Orders orders;
  std::atomic<bool> gone = false;
  const std::jthread reader([&] {
    while (std::optional<Frame> frame = read_frame(STDIN_FILENO)) {
      orders.put(std::move(*frame));
      bus.wake();
    }
    gone = true;
    bus.wake();
  });
  while (!gone) {
    bus.wait(std::chrono::seconds(1));
    while (const std::optional<Frame> order = orders.take()) write_frame(STDOUT_FILENO, answer(bus, *order));
    while (std::optional<bus::Delivery> delivery = bus.take()) {
      write_frame(STDOUT_FILENO,
                  {Op::delivery, static_cast<std::uint8_t>(delivery->topic), {}, std::move(delivery->cdr)});
    }
  }
}

}  // namespace
}  // namespace weft::contract

int main(int count, char** arguments) {
  using namespace weft::contract;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGPIPE, SIG_IGN);
  if (count < arguments_in_all) {
    std::fputs("usage: weft-bus-peer VENDOR ROLE HEX_ID DOMAIN LISTEN SERVER strict|lax PROCESS HOSTS\n", stderr);
    return 2;
  }
  if (!enter_network_of(arguments[process]) || !take_hosts_from(arguments[hosts])) {
    write_frame(STDOUT_FILENO, {Op::failed, 0, {}, bytes_of("cannot take the machine's network and hosts")});
    return 1;
  }
  auto bus = open_from(arguments);
  if (!bus) {
    write_frame(STDOUT_FILENO, {Op::failed, 0, {}, bytes_of(bus.error().message)});
    return 1;
  }
  write_frame(STDOUT_FILENO, {Op::opened, 0, {}, {}});
  relay(**bus);
  return 0;
}
