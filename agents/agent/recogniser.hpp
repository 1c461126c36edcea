#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "agents/navigation/navigator.hpp"
#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Asks the server which places of the whole network look like what the robot sees, for as long as the navigator
/// wants to know. Without an answer the navigator goes on with what there is.
class Recogniser {
 public:
  /// Begins with `first_request`, random for each incarnation, so that answers to an earlier one are not taken for
  /// ours.
  explicit Recogniser(std::uint64_t first_request) : request_(first_request) {}

  /// Sets the question that the navigator wants answered now; null: none.
  void want(const Question* open, SteadyTime now);
  /// Returns a question without its header, when it is time for one.
  std::optional<msg::Recognise> due(SteadyTime now);
  std::optional<SteadyTime> next() const;
  void server_restarted(SteadyTime now);

  struct Heard {
    std::uint64_t question = 0;
    std::vector<PlaceId> places;
    std::string note;  ///< for the log
  };
  /// Takes in an answer. None: it answers nothing that is asked now.
  std::optional<Heard> on_answer(const msg::Recognised& answer);
  /// Returns among how many the proposed ones were found, for people: "of 4211 (300 more are not signed yet)"; empty:
  /// no answer has come.
  const std::string& among() const { return among_; }

 private:
  std::optional<Question> open_;
  std::uint64_t request_;
  SteadyTime ask_at_{};
  SteadyTime last_asked_{};
  Duration wait_{};
  std::string among_;
};

}  // namespace weft::agents
