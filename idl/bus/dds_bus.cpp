#include "idl/bus/dds_bus.hpp"

#include <chrono>
#include <utility>

#include "core/text.hpp"

namespace weft::bus {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenLooks = 500ms;
constexpr std::size_t kNotices = 100;

SteadyTime steady() {
  return SteadyTime{std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch())};
}

Bytes key_of(const Topic& topic, ByteView cdr) {
  constexpr std::size_t kHeaderBytes = 4, kKeyBytes = 16;
  if (!topic.keyed) return {};
  const ByteView key = cdr.subspan(kHeaderBytes, kKeyBytes);
  return {key.begin(), key.end()};
}

/// Rejects an address that no interface has: most likely a slip. One without carrier or address yet is waited for.
Result<void> check_there(const LocalLink& link, const std::string& listen) {
  if (!link.interface.empty()) return {};
  return fail(ErrorCode::unavailable, "cannot listen on " + listen +
                                          ": no interface of this machine has that "
                                          "address; give one of those that `ip -brief address` lists, or an "
                                          "interface's name to wait for its address");
}

}  // namespace

DdsBus::DdsBus(BusConfig config, std::span<const Topic, kTopics> table, std::string vendor, JoinDomain join)
    : config_(std::move(config)),
      table_(table.begin(), table.end()),
      vendor_(std::move(vendor)),
      join_(std::move(join)),
      inbox_(config_.inbox_messages),
      keeping_(config_.listen),
      lookup_(config_) {}

DdsBus::~DdsBus() {
  keeper_.request_stop();
  if (keeper_.joinable()) keeper_.join();
  leave();
}

Result<void> DdsBus::start() {
  if (const Result<void> good = check(config_); !good) return good;
  const Result<LocalLink> link = local_link(config_.listen);
  if (!link) return fail(link.error());
  if (const Result<void> there = check_there(*link, config_.listen); !there) return there;
  if (!link->ipv4.empty()) {
    if (const auto ports = own_ports(config_, link->ipv4); !ports) return fail(ports.error());
  }
  if (link->carries) {
    Result<std::vector<ServerAddress>> servers = server_addresses(config_);
    if (!servers) return fail(std::move(servers.error()));
    servers_ = std::move(*servers);
    if (const Result<void> joined = join(link->ipv4); !joined) return joined;
  } else {
    act(keeping_.next({.now = steady(), .received = 0, .link = *link, .servers = servers_}), *link);
  }
  keeper_ = std::jthread([this](const std::stop_token& stop) { keep(stop); });
  return {};
}

Result<void> DdsBus::join(const std::string& listen) {
  const Result<Ports> own = own_ports(config_, listen);
  if (!own) return fail(own.error());
  for (const ServerAddress& server : *servers_) {
    if (const Result<void> reaches = check_reach(listen, server.ipv4); !reaches) return reaches;
  }
  const Addresses at{listen, *own, *servers_};
  Result<std::unique_ptr<Participant>> participant = join_(at, inbox_);
  // An interface that fails meanwhile is no error of who starts this: it is waited for.
  const LocalLink link = local_link(config_.listen).value_or(LocalLink{});
  if (participant ? !(*participant)->is_bound() : !link.carries) {
    keeping_.failed(steady(), listen + " lost its carrier or its address while the link was opened");
    return {};
  }
  if (!participant) return fail(std::move(participant.error()));
  {
    const std::lock_guard lock(mutex_);
    participant_ = std::move(*participant);
    for (const auto& [key, cdr] : states_) {
      std::ignore = participant_->write(table_[static_cast<std::size_t>(key.first)], {}, cdr);
    }
  }
  is_open_ = true;
  if (std::string notice = keeping_.joined(steady(), at); !notice.empty()) notify(std::move(notice));
  return {};
}

void DdsBus::leave() {
  is_open_ = false;
  std::unique_ptr<Participant> gone;  // ends outside the lock: it may take long
  const std::lock_guard lock(mutex_);
  gone = std::move(participant_);
}

void DdsBus::keep(const std::stop_token& stop) {
  SteadyTime looked = steady();
  while (!stop.stop_requested()) {
    const LocalLink link = local_link(config_.listen).value_or(LocalLink{});
    if (auto answer = lookup_.answer()) servers_ = std::move(answer);
    const SteadyTime now = steady();
    const Keeping::Decision decision = keeping_.next({.now = now,
                                                      .received = inbox_.counters().received,
                                                      .link = link,
                                                      .servers = servers_,
                                                      .is_unanswered = is_unanswered_.exchange(false),
                                                      .unseen = now - looked});
    act(decision, link);
    looked = steady();
    if (decision.step == Keeping::Step::leave) continue;  // and joins at once where it can
    std::unique_lock lock(mutex_);
    if (participant_ != nullptr) participant_->forget_readerless(steady());
    stopping_.wait_for(lock, stop, kBetweenLooks, [this] { return is_unanswered_.load(); });
  }
}

void DdsBus::act(const Keeping::Decision& decision, const LocalLink& link) {
  if (!decision.notice.empty()) notify(decision.notice);
  if (decision.asks_resolver) lookup_.ask();
  if (decision.step == Keeping::Step::leave) leave();
  if (decision.step != Keeping::Step::join) return;
  if (const Result<void> joined = join(link.ipv4); !joined) {
    keeping_.failed(steady(), one_line(joined.error().message));
  }
}

void DdsBus::open_anew() {
  {
    const std::lock_guard lock(mutex_);
    is_unanswered_ = true;
  }
  stopping_.notify_all();
}

void DdsBus::notify(std::string text) {
  {
    const std::lock_guard lock(mutex_);
    if (notices_.size() < kNotices) notices_.push_back(std::move(text));
  }
  inbox_.wake();
}

std::vector<std::string> DdsBus::drain_notices() {
  const std::lock_guard lock(mutex_);
  return std::exchange(notices_, {});
}

Result<void> DdsBus::publish(TopicId id, const PeerId& to, ByteView cdr) {
  const Topic& topic = table_[static_cast<std::size_t>(id)];
  Result<void> done = check_publish(topic, config_.role, to, cdr);
  if (done) done = write(topic, to, cdr);
  inbox_.count_publish(done, cdr.size() > topic.max_bytes);
  return done;
}

Result<void> DdsBus::write(const Topic& topic, const PeerId& to, ByteView cdr) {
  const std::lock_guard lock(mutex_);
  if (topic.delivering == Delivering::state) states_[{topic.id, key_of(topic, cdr)}] = Bytes(cdr.begin(), cdr.end());
  if (participant_ != nullptr) return participant_->write(topic, to, cdr);
  if (topic.delivering == Delivering::state) return {};  // is told once the link is open
  return fail(ErrorCode::unavailable, std::string(topic.name) + ": the link is not open; try again later");
}

BusCounters DdsBus::counters() const {
  BusCounters counters = inbox_.counters();
  const std::lock_guard lock(mutex_);
  counters.peers = participant_ == nullptr ? 0 : participant_->peers();
  return counters;
}

void DdsBus::forget(const PeerId& peer) {
  const std::lock_guard lock(mutex_);
  if (participant_ != nullptr) participant_->forget(peer);
}

}  // namespace weft::bus
