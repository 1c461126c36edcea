#include "server/fleet/link_directions.hpp"

#include "core/text.hpp"

namespace weft::server {
namespace {

/// Bounds from below the silences of which it is told which direction was dead.
constexpr double kShortest_s = 12.0;
/// Tells one dead direction from a link that is down. DDS gives up who has not been heard for 5 s, counted from an
/// announcement that may be a second old, so that the other direction dies 4 s later at least. Of a link that is down
/// both ends know within 3 s of each other: robots that stand speak every 3 s, servers greet every 2 s.
constexpr double kAheadOfTheOther_s = 3.5;
/// Is for how long a robot has been heard before what it has not heard counts.
constexpr double kSettled_s = 5.0;
/// Bounds from above for how long a robot has heard nothing that hears the server again.
constexpr double kHears_s = 3.0;

std::string of_silence(double silence_s, double gap_s) {
  const std::string lasted = "nothing came from it for " + fixed_number(silence_s, 0) +
                             " s, and it heard nothing for " + fixed_number(gap_s, 0) + " s: ";
  if (silence_s - gap_s >= kAheadOfTheOther_s) return lasted + "the direction from the robot to the server was dead";
  if (gap_s - silence_s >= kAheadOfTheOther_s) return lasted + "the direction from the server to the robot was dead";
  return lasted + "its link was down";
}

}  // namespace

void LinkDirections::heard_again(std::optional<Duration> silence, SteadyTime now) {
  since_ = now;
  silence_ = silence;
  is_deaf_ = false;
}

void LinkDirections::server_was_away(SteadyTime now) {
  since_ = now;
}

std::optional<LinkDirections::Told> LinkDirections::hear(const msg::RobotState& state, SteadyTime now) {
  if (silence_ && state.server_unheard_s < kHears_s) {
    const double silence_s = seconds(*silence_);
    silence_.reset();
    if (silence_s >= kShortest_s) return Told{"robot.unheard", of_silence(silence_s, state.server_gap_s)};
  }
  // Right after both directions were dead the robot may speak before it has heard anything.
  const bool is_settled = seconds(now - since_) >= kSettled_s;
  const bool hears_nothing = state.server_unheard_s >= msg::kDeaf_s && (is_settled || is_deaf_);
  if (hears_nothing == is_deaf_) return std::nullopt;
  is_deaf_ = hears_nothing;
  if (!hears_nothing) return Told{"robot.hears", "it hears the server again"};
  return Told{"robot.deaf", "it is heard, and has heard nothing of the server for " +
                                fixed_number(state.server_unheard_s, 0) +
                                " s: the direction from the server to the robot is dead"};
}

}  // namespace weft::server
