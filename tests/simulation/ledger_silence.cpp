#include <type_traits>

#include "tests/simulation/ledger.hpp"

/// Checks that the server knows whom it does not hear, and blames nobody for its own absence.
namespace weft::simulation {
namespace {

/// Is what a server waits for a robot's word by default, and how late its next look may be.
constexpr Duration kSilent = std::chrono::milliseconds(6000);

}  // namespace

void Ledger::note_heard(const msg::Message& message) {
  const auto from = std::visit(
      [](const auto& said) -> PeerId {
        if constexpr (std::is_same_v<std::decay_t<decltype(said)>, msg::Hello>) {
          return said.peer;
        } else {
          return said.header.sender;
        }
      },
      message);
  if (const auto robot = robots.find(from); robot != robots.end()) robot->second.heard = now_;
}

void Ledger::look_at_silence(const std::vector<msg::RobotRow>& rows) {
  for (const msg::RobotRow& row : rows) {
    const auto robot = robots.find(row.description.header.sender);
    if (robot == robots.end() || !row.is_heard) continue;
    const Duration silent = now_ - std::max(robot->second.heard, served_since_);
    if (silent <= kSilent) continue;
    broken("silence", robot->second.name + " counts as heard, and nothing has been heard of it for " +
                          std::to_string(seconds(silent)) + " s");
  }
}

void Ledger::server_woke(const std::vector<msg::Message>& said) {
  for (const msg::Message& message : said) {
    const auto* const note = std::get_if<msg::EventNote>(&message);
    if (note == nullptr || note->event.kind != "robot.silent") continue;
    broken("absence", "the server stood still and blames " + robots.at(note->event.robot).name + " for the silence");
  }
}

}  // namespace weft::simulation
