#include "tests/simulation/ledger.hpp"

#include <algorithm>
#include <cmath>

#include "agents/navigation/config.hpp"
#include "core/network/codec.hpp"

namespace weft::simulation {
namespace {

/// Returns the first index that the robot still touches: who stands at the end of its release touches nothing before.
std::uint32_t freed_by(const msg::RouteProgress& progress) {
  const bool stands = progress.phase == msg::RoutePhase::waiting && progress.at >= progress.released;
  return stands ? std::max(progress.freed, progress.released) : progress.freed;
}

/// Returns what is passed of the next version of a route when `passed` is of the one before: the same where both
/// begin by the same places. A route may come by one floor several times.
std::uint32_t passed_of(const Route& before, const Route& next, std::uint32_t passed) {
  const bool is_long_enough = passed < before.places.size() && passed < next.places.size();
  if (before.id != next.id || !is_long_enough) return 0;
  const auto end = before.places.begin() + passed + 1;
  return std::equal(before.places.begin(), end, next.places.begin()) ? passed : 0;
}

/// Returns the first place of the next version of a route that the one before was not released to.
std::uint32_t first_new(const Route& before, const Route& next) {
  if (before.id != next.id) return 0;
  const auto end = before.places.begin() + std::min<std::ptrdiff_t>(before.released + 1, std::ssize(before.places));
  const auto differs = std::mismatch(before.places.begin(), end, next.places.begin(), next.places.end()).first;
  return static_cast<std::uint32_t>(differs - before.places.begin());
}

}  // namespace

void Ledger::broken(const std::string& invariant, const std::string& what) {
  constexpr int most_of_a_kind = 3;
  if (++said_[invariant] > most_of_a_kind) return;
  std::vector<Violation>& noted = told_only_.contains(invariant) ? told_ : violations_;
  noted.push_back({invariant, what + ", at " + std::to_string(seconds(now_.time_since_epoch())) + " s"});
}

std::optional<Pose2> Ledger::truth_of(const PlaceId& place) const {
  const auto found = truth_.find(place);
  return found == truth_.end() ? std::nullopt : std::optional(found->second);
}

void Ledger::agent_sent(const RobotId& robot, const msg::Message& message) {
  Robot& by = robots.at(robot);
  if (const auto* state = std::get_if<msg::RobotState>(&message)) by.state = *state;
  if (const auto* is = std::get_if<msg::RobotDescription>(&message)) by.footprint_m = is->footprint_radius_m;
  if (const auto* request = std::get_if<msg::WindowRequest>(&message)) by.wants = request->definition;
  if (const auto* progress = std::get_if<msg::RouteProgress>(&message)) by.progress = *progress;
  note_stops(by, message);
  if (by.state.experience) {
    Run& run = runs_[by.state.experience];
    run.taught_in = by.state.header.incarnation;
    run.was_refused = run.was_refused || by.struck == now_;
  }
  if (const auto* sent = std::get_if<msg::ExperienceBatch>(&message)) {
    check_draft(by, *sent);
    const auto [known, first] = sent_[sent->batch.experience].emplace(sent->batch.sequence, sent->batch);
    if (!first && hash(known->second) != hash(sent->batch)) {
      broken("acknowledged",
             by.name + " sent two different batches under sequence " + std::to_string(sent->batch.sequence));
    }
    for (const Place& place : sent->batch.places) {
      if (const auto at = by.body->at_frame(place.frame)) truth_.emplace(place.id, *at);
    }
  }
}

void Ledger::agent_heard(const RobotId& robot, const msg::Message& message, const storage::MemoryDisk& disk) {
  const auto* command = std::get_if<msg::AgentCommand>(&message);
  if (command != nullptr && command->to == robot) robots.at(robot).commands[command->command] = command->kind;
  const auto* ack = std::get_if<msg::BatchAck>(&message);
  if (ack == nullptr || ack->to != robot) return;
  if (ack->refused_sequence != 0) refused_.insert(ack->experience);
  std::uint64_t& through = acknowledged_[ack->experience];
  for (; through < ack->durable_through; ++through, ++acknowledged_count_) {
    if (!disk.batch_hashes.contains({ack->experience, through + 1})) {
      broken("acknowledged", "batch " + std::to_string(through + 1) + " of " + to_string(ack->experience) +
                                 " was acknowledged and is not on the disk");
    }
  }
}

void Ledger::server_heard(const msg::Message& message) {
  note_heard(message);
  if (const auto* state = std::get_if<msg::RobotState>(&message)) {
    const RobotId sender = state->header.sender;
    msg::RobotState& known = known_[sender];
    const bool late =
        known.header.incarnation == state->header.incarnation && known.header.sequence > state->header.sequence;
    if (late) return;
    known = *state;
    if (std::exchange(robots.at(sender).unheard, false)) note_put_down(sender);
    const auto held = held_.find(sender);
    if (held == held_.end()) return;
    held->second.known = held->second.known || state->route == held->second.route.id;
    if (state->route == held->second.route.id || !held->second.known) return;
    // It says that it has no such route any more, and that is so.
    const agents::Agent* const agent = robots.at(sender).agent;
    const bool has_it = agent != nullptr && agent->route() && agent->route()->id == held->second.route.id;
    if (!has_it) held_.erase(held);
  }
  if (const auto* progress = std::get_if<msg::RouteProgress>(&message)) {
    const auto held = held_.find(progress->header.sender);
    if (held == held_.end() || held->second.route.id != progress->route) return;
    held->second.known = true;
    if (progress->version != held->second.route.version) return;
    held->second.from = std::max(held->second.from, std::min(freed_by(*progress), held->second.route.released));
    if (progress->phase == msg::RoutePhase::arrived) held->second.from = held->second.route.released;
  }
}

void Ledger::server_sent(const msg::Message& message, const server::Service& service) {
  if (const auto* order = std::get_if<msg::RouteOrder>(&message)) {
    const auto held = held_.find(order->to);
    if (!order->route.ended) {
      check_release(order->route, service.snapshot());
    } else if (held != held_.end() && held->second.route.id == order->route.id) {
      held->second.known = true;
    }
  }
  if (const auto* reply = std::get_if<msg::OperatorReply>(&message)) {
    const bool accepted = reply->outcome == msg::Outcome::accepted || reply->outcome == msg::Outcome::done;
    if (reply->goal && accepted) {
      bool stored = false;
      for (const Goal& goal : service.goals()) stored = stored || goal.id == reply->goal;
      if (!stored) broken("goals", "goal " + to_string(reply->goal) + " was accepted and is not stored");
    }
  }
}

void Ledger::client_heard(const msg::Message& message) {
  const auto* reply = std::get_if<msg::OperatorReply>(&message);
  if (reply == nullptr || !reply->goal) return;
  if (reply->outcome == msg::Outcome::accepted || reply->outcome == msg::Outcome::done) accepted_.insert(reply->goal);
}

bool Ledger::are_close(const PlaceId& a, const PlaceId& b) const {
  const double apart_m = 2.0 * footprint_m_ - 0.15;  // what localisation may be off by
  const auto here = truth_of(a);
  const auto there = truth_of(b);
  return here && there && (here->translation() - there->translation()).norm() < apart_m;
}

/// Returns where the server last heard that the robot stands; none: nowhere, or at a place that nobody knows.
std::optional<Pose2> Ledger::said_to_stand(const RobotId& robot) const {
  const auto known = known_.find(robot);
  if (known == known_.end() || !known->second.localised) return std::nullopt;
  const auto place = truth_of(known->second.place);
  if (!place) return std::nullopt;
  return *place * planar(known->second.place_from_robot);
}

/// Returns whether the robot stands within what another one was given, and the place is no nearer to that: out of
/// there it may. One that is led by hand may have come farther than the server has heard.
bool Ledger::moves_away(const RobotId& robot, const PlaceId& place, const Route& theirs, std::uint32_t from) const {
  constexpr double same_m = 0.15;
  const auto nearest_m = [&](const Eigen::Vector2d& at) {
    double least_m = 1e9;
    for (std::uint32_t k = from; k <= theirs.released && k < theirs.places.size(); ++k) {
      if (const auto held = truth_of(theirs.places[k]))
        least_m = std::min(least_m, (held->translation() - at).norm());
    }
    return least_m;
  };
  const auto there = truth_of(place);
  if (!there) return false;
  const MarksBody& body = *robots.at(robot).body;
  double stands_m = nearest_m(body.site_from_robot().translation());
  if (const auto said = said_to_stand(robot); said && body.by_hand())
    stands_m = std::min(stands_m, nearest_m(said->translation()));
  return nearest_m(there->translation()) > stands_m - same_m;
}

/// A new piece of released route keeps clear of every other robot that the server knows the place of.
void Ledger::check_release(const Route& route, const Snapshot& snapshot) {
  const auto before = held_.find(route.robot);
  const bool continued =
      before != held_.end() && before->second.route.id == route.id && before->second.route.version == route.version;
  const Robot& mine = robots.at(route.robot);
  const std::uint32_t kept = before != held_.end() ? passed_of(before->second.route, route, before->second.from) : 0;
  const std::uint32_t first =
      continued ? before->second.route.released + 1 : std::max(kept, ahead_from(mine, route, kept));
  const std::uint32_t next = before != held_.end() ? std::max(first, first_new(before->second.route, route)) : first;
  for (std::uint32_t i = next; i <= route.released && i < route.places.size(); ++i) {
    check_standing(route.robot, route.places[i], snapshot);
    for (const auto& [other, stretch] : held_) {
      if (other == route.robot) continue;
      for (std::uint32_t k = stretch.from; k <= stretch.route.released && k < stretch.route.places.size(); ++k) {
        if (!are_close(route.places[i], stretch.route.places[k])) continue;
        if (moves_away(route.robot, route.places[i], stretch.route, stretch.from)) continue;
        broken("occupancy", mine.name + " was released to " + to_string(route.places[i]) + " which " +
                                robots.at(other).name + " holds at " + to_string(stretch.route.places[k]));
        break;
      }
    }
  }
  check_rules(route, first, next, snapshot);
  held_[route.robot] = {route, continued ? before->second.from : first, continued && before->second.known};
}

/// Nobody is sent through a robot that stands where it has told the server that it stands.
void Ledger::check_standing(const RobotId& id, const PlaceId& place, const Snapshot& snapshot) {
  const Robot& robot = robots.at(id);
  for (const auto& [other, known] : known_) {
    const Robot& standing = robots.at(other);
    if (&standing == &robot || held_.contains(other)) continue;
    if (!known.localised || known.mode != msg::RobotMode::idle || known.route) continue;
    if (snapshot.place(known.place) == nullptr || !are_close(place, known.place)) continue;
    Route stands;
    stands.places = {known.place};
    if (moves_away(id, place, stands, 0)) continue;
    broken("occupancy", robot.name + " was released to " + to_string(place) + " where " + standing.name +
                            " stands, at " + to_string(known.place));
  }
}

/// Returns what the robot has said that it has passed of the route.
std::uint32_t Ledger::passed_by(const Robot& robot, const Route& route) const {
  const bool said = robot.progress.route == route.id && robot.progress.version == route.version;
  return said ? freed_by(robot.progress) : 0;
}

/// Returns the first of a route's places that the robot may still drive to, not before what is known to be passed. A
/// robot that was restarted takes its route up from where it stands, and has not said yet what it freed; one that was
/// put down beside its route drives on from where that is nearest.
std::uint32_t Ledger::ahead_from(const Robot& robot, const Route& route, std::uint32_t passed) const {
  constexpr double here_m = 0.6;
  const bool said = robot.progress.route == route.id && robot.progress.version == route.version;
  if (said && robot.progress.phase == msg::RoutePhase::arrived) return route.released;
  const std::uint32_t from = said ? std::max(passed, freed_by(robot.progress)) : passed;
  const Eigen::Vector2d at = robot.body->site_from_robot().translation();
  const auto away_m = [&](std::uint32_t index) {
    const auto place = truth_of(route.places[index]);
    return place ? (place->translation() - at).norm() : here_m;
  };
  for (std::uint32_t i = from; i <= route.released; ++i) {
    if (away_m(i) >= here_m) continue;
    while (i < route.released && away_m(i + 1) < away_m(i)) ++i;
    return i;
  }
  return from;
}

/// Checks that what two robots were given and have not driven yet keeps clear, whatever the server thinks.
void Ledger::agent_took(const RobotId& robot) {
  Robot& mine = robots.at(robot);
  const std::optional<Route> route = mine.agent->route();
  const bool same = route && mine.had && route->id == mine.had->id && route->version == mine.had->version;
  if (same && route->released == mine.had->released) return;
  const std::uint32_t first = same ? mine.had->released + 1 : 0;
  const std::uint32_t known = mine.had ? std::max(mine.passed, passed_by(mine, *mine.had)) : 0;
  mine.passed = same ? known : route && mine.had ? passed_of(*mine.had, *route, known) : 0;
  mine.had = route;
  mine.stands_since = now_;
  if (!route) return;
  const std::uint32_t begin = std::max(first, ahead_from(mine, *route, mine.passed));
  for (const auto& [id, other] : robots) {
    if (id == robot || other.agent == nullptr) continue;
    const std::optional<Route> theirs = other.agent->route();
    if (!theirs) continue;
    const std::uint32_t from = ahead_from(other, *theirs, other.passed);
    for (std::uint32_t i = begin; i <= route->released; ++i) {
      for (std::uint32_t k = from; k <= theirs->released; ++k) {
        if (!are_close(route->places[i], theirs->places[k])) continue;
        // Excuses the one that is let out of what the other one holds, whichever of them has heard first.
        if (moves_away(robot, route->places[i], *theirs, from) || moves_away(id, theirs->places[k], *route, begin))
          continue;
        broken("occupancy", mine.name + " may drive to " + to_string(route->places[i]) + " and " + other.name +
                                " to " + to_string(theirs->places[k]));
        return;
      }
    }
  }
}

void Ledger::agent_stepped(const RobotId& robot, const agents::Sample& sample, const agents::AgentOutput& output) {
  Robot& by = robots.at(robot);
  check_stops(by, sample, output.command);
  check_lost(by, output);
  if (!by.body->by_hand()) {
    check_released_point(by);
    check_belief(by);
    check_limits(by);
  }
}

/// A robot that does not know where it is stays within its footprint. It turns on the spot at most, and only if its
/// method looks around.
void Ledger::check_lost(Robot& by, const agents::AgentOutput& output) {
  constexpr bool turns = agents::Recovers<agents::MarksMethod>;
  const agents::Twist& command = output.command;
  const bool stays = command.linear_m_s == 0.0 && (turns || command.angular_rad_s == 0.0);
  const auto estimate = by.agent == nullptr ? std::nullopt : by.agent->estimate();
  // What it said last may be older than the view that has just shown it where it is.
  const bool found = estimate && estimate->blind_m <= agents::FollowConfig{}.blind_limit_m;
  const bool lost = by.state.mode == msg::RobotMode::lost && !found && !by.body->by_hand();
  if (lost && !stays) {
    broken("lost_stays",
           by.name + " says that it is lost and drives at " + std::to_string(command.linear_m_s) + " m/s");
  }
  // A robot this far after its last fix should know that it is lost, and stay, whatever it says of itself.
  constexpr double most_blind_m = agents::FollowConfig{}.blind_limit_m + 0.3;
  if (!by.body->by_hand() && estimate && estimate->blind_m > most_blind_m && !stays) {
    broken("lost_stays", by.name + " drives " + std::to_string(estimate->blind_m) + " m after its last fix");
  }
  if (!lost || by.led) return by.lost_at.reset();
  const Eigen::Vector2d here = by.body->site_from_robot().translation();
  constexpr double still_m_s = 0.01;
  if (!by.lost_at && std::abs(by.body->true_speed_m_s()) < still_m_s) by.lost_at = here;
  if (by.lost_at && (here - *by.lost_at).norm() > by.footprint_m) {
    broken("lost_stays",
           by.name + " is lost and has left its footprint by " + std::to_string((here - *by.lost_at).norm()) + " m");
  }
}

/// Notes on whose way a hand has put it.
void Ledger::note_put_down(const RobotId& robot) {
  constexpr double aside_m = 0.3;  // of the way that it is driven
  const Robot& mine = robots.at(robot);
  const Eigen::Vector2d here = mine.body->site_from_robot().translation();
  for (const auto& [id, other] : robots) {
    if (id == robot || other.agent == nullptr) continue;
    const std::optional<Route> route = other.agent->route();
    if (!route) continue;
    const double reach_m = mine.footprint_m + other.footprint_m + aside_m;
    for (std::uint32_t i = ahead_from(other, *route, other.passed); i <= route->released; ++i) {
      const auto place = truth_of(route->places[i]);
      if (place && (place->translation() - here).norm() < reach_m) contacts_.put_down_before(robot, id);
    }
  }
}

/// Two bodies never touch while one of them drives by itself.
void Ledger::body_moved(const RobotId& robot) {
  constexpr double moves_m_s = 0.01;
  Robot& mine = robots.at(robot);
  const bool moves = std::abs(mine.body->true_speed_m_s()) > moves_m_s;
  const bool led = mine.body->by_hand() || (mine.led && moves);  // until it has rolled out
  const Stance stance{mine.body->site_from_robot().translation(), mine.footprint_m, moves && !led, led};
  const std::vector<Contacts::Touch> touches = contacts_.moved(robot, stance);
  if (mine.led && !stance.led) {
    note_put_down(robot);
    mine.unheard = true;
  }
  if (stance.led || stance.drives) mine.unheard = false;
  mine.led = stance.led;
  if (moves || stance.led || !is_at_work(mine)) mine.stands_since = now_;
  if (stance.drives) mine.drove = now_;
  if (stance.drives) check_driver(robot, mine);
  for (const Contacts::Touch& touch : touches) {
    const Robot& other = robots.at(touch.other);
    if (mine.unheard || other.unheard) continue;
    const Robot& driver = stance.drives ? mine : other;
    const Robot& met = stance.drives ? other : mine;
    const std::optional<Route> route = driver.agent != nullptr ? driver.agent->route() : std::nullopt;
    const auto end = route ? truth_of(route->places[route->released]) : std::nullopt;
    const double away_m =
        end ? (end->translation() - met.body->site_from_robot().translation()).norm() : std::nan("");
    broken("contact", driver.name + " drives into " + met.name + ", " + std::to_string(-touch.gap_m) +
                          " m deep, at " + to_string(driver.state.place) + " and " + to_string(met.state.place) +
                          "; its released point is " + std::to_string(away_m) + " m from there");
  }
}

/// Checks by the truth that a robot on a route is not ahead of the released place.
void Ledger::check_released_point(const Robot& robot) {
  if (robot.agent == nullptr || std::abs(robot.body->true_speed_m_s()) < 0.01) return;
  const std::optional<Route> route = robot.agent->route();
  if (!route || route->released + 1 >= route->places.size()) return;
  // A route may come by its beginning again at its end.
  constexpr std::uint32_t near = 15;
  const bool said = robot.progress.route == route->id && robot.progress.version == route->version;
  if (!said || robot.progress.at + near < route->released) return;
  const auto at = truth_of(route->places[route->released]);
  if (!at) return;
  const Pose2 beyond = at->inverse() * robot.body->site_from_robot();
  if (beyond.x > 0.25 && beyond.x < 1.0 && std::abs(beyond.y) < 0.4) {
    broken("released_point", robot.name + " is " + std::to_string(beyond.x) + " m beyond its released place " +
                                 to_string(route->places[route->released]));
  }
}

/// A robot that drives by itself is where it believes to be.
void Ledger::check_belief(const Robot& robot) {
  if (robot.agent == nullptr || robot.body->true_speed_m_s() < 0.2) return;
  const auto estimate = robot.agent->estimate();
  if (!estimate) return;
  const auto place = truth_of(estimate->place);
  if (!place) return;
  const Pose2 off = (*place * planar(estimate->place_from_robot)).inverse() * robot.body->site_from_robot();
  if (off.translation().norm() > 0.4) {
    broken("belief",
           robot.name + " drives " + std::to_string(off.translation().norm()) + " m from where it believes to be");
  }
}

}  // namespace weft::simulation
