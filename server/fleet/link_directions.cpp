#include "server/fleet/link_directions.hpp"

#include "core/text.hpp"

namespace weft::server {
namespace {

/// Bounds from below the silences of a robot of which it is told what it heard meanwhile: servers greet every 5 s, so
/// that within less nothing follows from what was not heard.
constexpr double kShortest_s = 12.0;

std::string of_silence(double silence_s, double gap_s) {
  const std::string lasted = fixed_number(silence_s, 0) + " s";
  if (gap_s >= silence_s / 2.0) {
    return "nothing came from it for " + lasted + ", and nothing came to it either: its link was down";
  }
  return "nothing came from it for " + lasted +
         " while it heard the server: the direction from the robot to the server was dead";
}

}  // namespace

void LinkDirections::heard_again(std::optional<Duration> silence, SteadyTime now) {
  since_ = now;
  silence_ = silence;
  is_deaf_ = false;
}

std::optional<LinkDirections::Told> LinkDirections::hear(const msg::RobotState& state, SteadyTime now) {
  if (silence_) {
    const double silence_s = seconds(*silence_);
    silence_.reset();
    if (silence_s >= kShortest_s) return Told{"robot.unheard", of_silence(silence_s, state.server_gap_s)};
  }
  // Right after both directions were dead the robot may speak before it has heard anything.
  const bool is_settled = seconds(now - since_) >= msg::kDeaf_s / 2.0;
  const bool hears_nothing = state.server_unheard_s >= msg::kDeaf_s && is_settled;
  if (hears_nothing == is_deaf_) return std::nullopt;
  is_deaf_ = hears_nothing;
  if (!hears_nothing) return Told{"robot.hears", "it hears the server again"};
  return Told{"robot.deaf", "it is heard, and has heard nothing of the server for " +
                                fixed_number(state.server_unheard_s, 0) +
                                " s: the direction from the server to the robot is dead"};
}

}  // namespace weft::server
