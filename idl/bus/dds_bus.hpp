#pragma once
#include <atomic>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include "idl/bus/keeping.hpp"
#include "idl/bus/participant.hpp"
#include "idl/bus/server_lookup.hpp"

namespace weft::bus {

/// Keeps a bus over one vendor's participant, which it replaces when the link comes up late, when the own address
/// changes or when the server has moved. The keeper's thread watches and opens, so that nobody else waits for vendors
/// or resolvers.
class DdsBus final : public Bus {
 public:
  DdsBus(BusConfig config, std::span<const Topic, kTopics> table, std::string vendor, JoinDomain join);
  ~DdsBus() override;
  DdsBus(const DdsBus&) = delete;
  DdsBus& operator=(const DdsBus&) = delete;

  /// Joins, or says what it waits for. Fails on what waiting does not mend.
  Result<void> start();

  Result<void> publish(TopicId id, const PeerId& to, ByteView cdr) override;
  std::optional<Delivery> take() override { return inbox_.take(); }
  bool wait(Duration at_most) override { return inbox_.wait(at_most); }
  void wake() override { inbox_.wake(); }
  std::string vendor() const override { return vendor_; }
  msg::Role role() const override { return config_.role; }
  BusCounters counters() const override;
  void forget(const PeerId& peer) override;
  bool is_open() const override { return is_open_; }
  void open_anew() override;
  std::vector<std::string> drain_notices() override;

 private:
  /// Opens a participant. A link that fails meanwhile is no error: the keeper tries again.
  Result<void> join(const std::string& listen);
  void leave();
  void keep(const std::stop_token& stop);
  void act(const Keeping::Decision& decision, const LocalLink& link);
  void notify(std::string text);
  Result<void> write(const Topic& topic, const PeerId& to, ByteView cdr);

  const BusConfig config_;
  const std::vector<Topic> table_;
  const std::string vendor_;
  const JoinDomain join_;
  Inbox inbox_;  ///< outlives every participant
  std::atomic<bool> is_open_ = false;
  std::atomic<bool> is_unanswered_ = false;  ///< since the keeper's last look

  mutable std::mutex mutex_;
  // Guarded by mutex_:
  std::unique_ptr<Participant> participant_;
  std::map<std::pair<TopicId, Bytes>, Bytes>
      states_;  ///< the last of each key: a new participant has to tell it anew
  std::vector<std::string> notices_;

  // The keeper's alone, once start() has returned:
  Keeping keeping_;
  ServerLookup lookup_;
  std::optional<std::vector<ServerAddress>> servers_;
  std::condition_variable_any stopping_;
  std::jthread keeper_;  ///< last member: stops first
};

}  // namespace weft::bus
