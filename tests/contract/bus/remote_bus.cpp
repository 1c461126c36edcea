#include "tests/contract/bus/remote_bus.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

namespace weft::contract {
namespace {

const char* name(bus::Vendor vendor) {
  return vendor == bus::Vendor::fastdds ? "fastdds" : "cyclonedds";
}

const char* name(msg::Role role) {
  return role == msg::Role::server ? "server" : role == msg::Role::client ? "client" : "agent";
}

/// Starts a child; returns its pid, 0 when it cannot be started.
pid_t spawn(std::vector<std::string> arguments, int in, int out) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);  // the server's sockets are not the child's
  pid_t child = 0;
  const int error = posix_spawn(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? child : 0;
}

}  // namespace

Result<std::unique_ptr<RemoteBus>> RemoteBus::start(const Options& options) {
  int orders[2], answers[2];
  if (pipe2(orders, O_CLOEXEC) != 0 || pipe2(answers, O_CLOEXEC) != 0) return fail(ErrorCode::internal, "no pipe");
  std::signal(SIGPIPE, SIG_IGN);
  const pid_t child = spawn({WEFT_BUS_PEER, name(options.vendor), name(options.role), to_string(options.self),
                             std::to_string(options.domain), options.listen, options.server,
                             options.lax ? "lax" : "strict", std::to_string(options.network_of), options.hosts},
                            orders[0], answers[1]);
  close(orders[0]);
  close(answers[1]);
  std::unique_ptr<RemoteBus> bus(new RemoteBus(child, orders[1], answers[0], options));
  if (child == 0) return fail(ErrorCode::internal, "cannot start " WEFT_BUS_PEER);
  const std::optional<Frame> first = read_frame(bus->from_child_);
  if (!first || first->op != Op::opened) {
    return fail(ErrorCode::unavailable, first ? text_of(first->bytes) : "the peer died before it opened its bus");
  }
  return bus;
}

RemoteBus::RemoteBus(pid_t child, int to_child, int from_child, const Options& options)
    : child_(child),
      to_child_(to_child),
      from_child_(from_child),
      vendor_(name(options.vendor)),
      role_(options.role) {}

RemoteBus::~RemoteBus() {
  close(to_child_);    // the child ends,
  close(from_child_);  // even when it is telling us something
  if (child_ > 0) waitpid(child_, nullptr, 0);
}

void RemoteBus::kill() {
  if (child_ <= 0) return;
  ::kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
  child_ = 0;
}

std::optional<Frame> RemoteBus::ask(const Frame& order) const {
  if (child_ == 0 || !write_frame(to_child_, order)) return std::nullopt;
  while (std::optional<Frame> frame = read_frame(from_child_)) {
    if (frame->op != Op::delivery) return frame;
    inbox_.push_back({bus::TopicId{frame->number}, std::move(frame->bytes)});
  }
  return std::nullopt;
}

Result<void> RemoteBus::publish(bus::TopicId topic, const PeerId& to, ByteView cdr) {
  const auto answer = ask({Op::publish, static_cast<std::uint8_t>(topic), to, Bytes(cdr.begin(), cdr.end())});
  if (!answer) return fail(ErrorCode::unavailable, "the peer's process is gone");
  if (answer->number == kNoError) return {};
  return fail(static_cast<ErrorCode>(answer->number), text_of(answer->bytes));
}

std::optional<bus::Delivery> RemoteBus::take() {
  if (inbox_.empty() && child_ > 0 && wait(Duration{})) {
    std::optional<Frame> frame = read_frame(from_child_);
    if (frame) return bus::Delivery{bus::TopicId{frame->number}, std::move(frame->bytes)};
  }
  if (inbox_.empty()) return std::nullopt;
  bus::Delivery first = std::move(inbox_.front());
  inbox_.pop_front();
  return first;
}

bool RemoteBus::wait(Duration at_most) {
  if (!inbox_.empty()) return true;
  pollfd waited{from_child_, POLLIN, 0};
  const auto limit = std::chrono::duration_cast<std::chrono::milliseconds>(at_most).count();
  return poll(&waited, 1, static_cast<int>(limit)) > 0 && (waited.revents & POLLIN) != 0;
}

bus::BusCounters RemoteBus::counters() const {
  bus::BusCounters counters;
  const auto answer = ask({Op::ask_counters, 0, {}, {}});
  if (answer) std::memcpy(&counters, answer->bytes.data(), sizeof counters);
  return counters;
}

void RemoteBus::forget(const PeerId& peer) {
  ask({Op::forget, 0, peer, {}});
}

}  // namespace weft::contract
