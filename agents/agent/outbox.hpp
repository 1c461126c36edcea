#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "agents/agent/agent.hpp"
#include "agents/agent/session.hpp"

namespace weft::agents {

/// Collects what one call into the agent leads to, in order: messages with the session's header, and what the body,
/// the records and the log are given.
class Outbox {
 public:
  explicit Outbox(Session& session) : session_(session) {}

  template <class M>
  void send(M message) {
    message.header = session_.header();
    output_.send.emplace_back(std::move(message));
  }
  /// Sends a hello, which carries no header.
  void send(msg::Hello hello) { output_.send.emplace_back(std::move(hello)); }

  void note(std::string text) { output_.notes.push_back(std::move(text)); }
  void record(const FixRecord& fix) { output_.fixes.push_back(fix); }
  void record(const std::vector<AckRecord>& acks) {
    output_.acks.insert(output_.acks.end(), acks.begin(), acks.end());
  }

  void expose(const std::optional<ExposureWish>& wish) { output_.exposes = wish; }
  void start_hand(std::vector<SitePoint> along) { output_.hand_start = std::move(along); }
  void stop_hand() { output_.hand_stop = true; }

  /// Hands everything over, with the command that is in force from now on, and is empty afterwards.
  AgentOutput take(const Twist& command) {
    output_.command = command;
    return std::exchange(output_, AgentOutput{});
  }

 private:
  Session& session_;
  AgentOutput output_;
};

}  // namespace weft::agents
