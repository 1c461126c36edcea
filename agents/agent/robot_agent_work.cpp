#include <algorithm>
#include <utility>

#include "agents/agent/robot_agent.hpp"
#include "agents/agent/surroundings.hpp"
#include "agents/navigation/far_off.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr std::uint32_t kSeedHops = 3;      ///< map around a seed before looking for oneself there
constexpr std::uint32_t kRouteAhead = 10;   ///< places of a route to have before driving it
constexpr Duration kHandingInAtMost = 15s;  ///< then say that it is not yet done
constexpr Duration kSearchAtMost = 60s;     ///< then say that it was in vain
constexpr Duration kBetweenSearches = 10s;  ///< of one's own accord

bool contains(const std::vector<ExperienceId>& all, ExperienceId one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

/// Whoever has led the robot is still there, and can lead it on to where it meets what was taught before.
std::string what_was_taught(const Teaching& teaching) {
  const std::string places = std::to_string(teaching.kept) + (teaching.kept == 1 ? " place" : " places");
  return teaching.joined > 0
             ? places + ", " + std::to_string(teaching.joined) +
                   " joined to what was taught before, or to its own beginning"
             : places +
                   ", none joined to what was taught before, nor to its own beginning, in a way that can be driven";
}
}  // namespace

bool HandingIn::has(ExperienceId other) const {
  return other == experience || contains(others, other);
}

bool Teaching::joins(const Edge& edge) const {
  const bool is_own = edge.id.a.experience == experience || contains(others, edge.id.a.experience);
  if (edge.origin != Origin::stitch || edge.drivable == Drivable::none) return false;
  return !is_own || edge.id.a.experience == edge.id.b.experience;
}

std::string name_of_other(const std::string& name, const std::string& method) {
  return name.empty() ? std::string{} : name + "-" + method;
}

void RobotAgent::work(SteadyTime now) {
  prepare_teaching(now);
  if (teaching_.has_value() && teaching_->phase == Teaching::Phase::ending && now >= teaching_->deadline) {
    end_teaching(now);
  }
  give_up_keeping(now);
  hand_in_lessons(now);
  if (handing_in_.has_value()) finish_handing_in(now);
  prepare_localising(now);
  search_when_of_use(now);
  try_follow(now);
}

void RobotAgent::prepare_teaching(SteadyTime now) {
  if (!teaching_.has_value()) return;
  if (teaching_->phase == Teaching::Phase::seeking && now >= teaching_->deadline) {
    refuse(teaching_->started_by, config_.name + " did not find itself around " + to_string(*teaching_->seed) +
                                      ": move it nearer, or teach without a seed");
    teaching_.reset();
    navigator_->seek(std::nullopt);  // the seed has led to nothing
    return;
  }
  if (teaching_->phase != Teaching::Phase::preparing) return;
  const MapView map = map_view();
  const bool ready = !teaching_->seed.has_value() ||
                     (replica_.is_settled() && is_covered(map, navigator_->teaches(), *teaching_->seed, kSeedHops));
  if (!ready) {
    if (now < teaching_->deadline) return;
    refuse(teaching_->started_by, "the map around " + to_string(*teaching_->seed) +
                                      " did not arrive in 20 s: is that place in `weft map info`?");
    teaching_.reset();
    return;
  }
  if (!teaching_->seed.has_value()) return start_hand();
  teaching_->phase = Teaching::Phase::seeking;
  teaching_->deadline = now + kSearchAtMost;
  navigator_->seek(teaching_->seed);
}

void RobotAgent::start_hand() {
  if (teaching_->along.empty()) return begin_teaching();
  teaching_->phase = Teaching::Phase::hand;
  output_.hand_start = teaching_->along;
}

AgentOutput RobotAgent::hand_answered(const Result<void>& answer, SteadyTime now) {
  if (!teaching_.has_value()) return finish(now);
  if (teaching_->phase == Teaching::Phase::hand) {
    if (answer) {
      begin_teaching();
    } else {
      refuse(teaching_->started_by, answer.error().message);
      teaching_.reset();
    }
  } else if (teaching_->next_part.has_value()) {
    const CommandKey key = *std::exchange(teaching_->next_part, std::nullopt);
    if (!answer) {
      refuse(key, answer.error().message);
      return finish(now);
    }
    // Whoever waits for the end of this part is not to see the end of the last one.
    teaching_->hand_done = false;
    send(state());
    msg::AgentReply done;
    done.done = true;
    done.experience = teaching_->experience;
    reply(key, done);
  }
  return finish(now);
}

void RobotAgent::begin_teaching() {
  teaching_->phase = Teaching::Phase::on;
  navigator_->begin_teach({.experience = teaching_->experience, .robot = config_.self, .others = teaching_->others});
  spooler_.begin(teaching_->experience, teaching_->name);
  const std::vector<std::string> methods = navigator_->teaches();
  for (std::size_t i = 0; i < teaching_->others.size(); ++i) {
    spooler_.begin(teaching_->others[i], name_of_other(teaching_->name, methods[i + 1]));
  }
  msg::AgentReply done;
  done.done = true;
  done.experience = teaching_->experience;
  reply(teaching_->started_by, done);
}

void RobotAgent::end_teaching(SteadyTime now) {
  msg::AgentReply done;
  done.done = true;
  done.experience = teaching_->experience;
  navigator_->leave_teach();
  if (Result<void> sealed = spooler_.seal("taught to its end", now); !sealed) {
    done.done = false;
    done.reason = sealed.error().message;
    teaching_failed_ = "teaching ended: " + done.reason;
    navigator_->forget_taught(replica_.window());
  }
  if (const std::optional<CommandKey> asked_by = teaching_->stopped_by; asked_by.has_value()) {
    if (done.done) {
      handing_in_ = HandingIn{teaching_->experience, teaching_->others, *asked_by, now + kHandingInAtMost,
                              what_was_taught(*teaching_)};
    } else {
      reply(*asked_by, done);
    }
  }
  teaching_.reset();
  for (const CommandKey& key : std::exchange(keeping_, {})) refuse(key, "teaching ended before a place was kept");
}

/// "Stopped" is said when the map has all of it, so that whoever asked can go on with it.
void RobotAgent::finish_handing_in(SteadyTime now) {
  const std::vector<ExperienceId>& others = handing_in_->others;
  const bool pending =
      spooler_.is_pending(handing_in_->experience) ||
      std::any_of(others.begin(), others.end(), [this](ExperienceId other) { return spooler_.is_pending(other); });
  if (pending && now < handing_in_->deadline) return;
  msg::AgentReply done;
  done.done = true;
  done.experience = handing_in_->experience;
  done.reason = handing_in_->what;
  if (pending) done.reason += "; the server has not acknowledged all of it yet: the rest is on the robot's disk";
  const CommandKey key = handing_in_->asked_by;
  handing_in_.reset();
  reply(key, done);
}

void RobotAgent::stop_teaching(const std::string& reason, SteadyTime now) {
  bool is_spooled = true;
  for (const Kept& last : navigator_->end_teach(map_view())) is_spooled = bool(spooler_.add(last, now)) && is_spooled;
  navigator_->leave_teach();
  // What has been taught until then stays, as far as the spool takes it.
  is_spooled = bool(spooler_.seal("teaching broke off", now)) && is_spooled;
  if (!is_spooled) navigator_->forget_taught(replica_.window());
  output_.hand_stop = true;
  teaching_failed_ = reason;
  output_.notes.push_back(reason);
  const Teaching::Phase phase = teaching_->phase;
  if (phase != Teaching::Phase::on && phase != Teaching::Phase::ending) {
    refuse(teaching_->started_by, reason);
  }
  if (teaching_->stopped_by.has_value()) refuse(*teaching_->stopped_by, reason);
  if (teaching_->next_part.has_value()) refuse(*teaching_->next_part, reason);
  for (const CommandKey& key : std::exchange(keeping_, {})) refuse(key, reason);
  teaching_.reset();
}

/// The server will never hear of some of it: the robot is not to go on as if it were there.
void RobotAgent::abandon_teaching(const std::string& reason, SteadyTime now) {
  if (teaching_.has_value()) stop_teaching("teaching ended: " + reason, now);
  navigator_->forget_taught(replica_.window());
}

void RobotAgent::keep(const std::vector<Kept>& kept, SteadyTime now) {
  if (!teaching_.has_value()) return;
  for (const Kept& one : kept) {
    cache_.put(one.place.content.hash, one.content);
    if (Result<void> added = spooler_.add(one, now); !added) return abandon_teaching(added.error().message, now);
    ++teaching_->kept;
    const auto joins = [this](const Edge& edge) { return teaching_->joins(edge); };
    if (std::any_of(one.edges.begin(), one.edges.end(), joins)) ++teaching_->joined;
  }
  if (kept.empty() || keeping_.empty()) return;
  if (Result<void> flushed = spooler_.flush(now); !flushed) return abandon_teaching(flushed.error().message, now);
  for (const CommandKey& key : std::exchange(keeping_, {})) {
    msg::AgentReply done;
    done.done = true;
    done.place = kept.back().place.id;
    done.experience = kept.back().place.id.experience;
    reply(key, done);
  }
}

void RobotAgent::start_localising(std::optional<CommandKey> asked_by, const std::optional<PlaceId>& seed,
                                  SteadyTime now) {
  localising_ = Localising{.asked_by = asked_by, .seed = seed, .seeking = false, .deadline = now + kMapAtMost};
  searched_at_ = replica_.window().revision;
  search_at_ = now + kBetweenSearches;
  if (task_.route().has_value() && !task_.arrived()) {
    follow_pending_ = true;
    follow_at_latest_ = now + kMapAtMost;
  }
  if (seed.has_value()) forget_proposed();
  WindowDefinition definition = seed.has_value() ? usual_window() : replica_.definition();
  if (seed.has_value()) {
    is_for_proposed_ = false;
    definition.centre = seed;
  } else if (replica_.window().places.empty()) {
    definition.centre.reset();
  }
  replica_.define(std::move(definition), now);
}

void RobotAgent::prepare_localising(SteadyTime now) {
  if (!localising_.has_value()) return;
  if (localising_->seeking) {
    if (now < localising_->deadline) return;
    const std::optional<CommandKey> asked_by = localising_->asked_by;
    if (localising_->seed.has_value()) navigator_->seek(std::nullopt);  // it has led to nothing
    if (localising_->believes) {
      navigator_->stop_looking();
      forget_proposed();
    }
    localising_.reset();
    if (asked_by.has_value()) {
      const std::string likeliest =
          proposed_.empty() ? "" : " that look most like what it sees, " + recogniser_.among();
      refuse(*asked_by, config_.name + " did not find itself among " +
                            std::to_string(replica_.window().places.size()) + " places" + likeliest +
                            ": give --at LABEL, or move it near a place that was taught");
    }
    return;
  }
  const MapView map = map_view();
  // Without a seed there is something to ask from the first view on, whatever has come of the map.
  const bool covered = localising_->seed.has_value()
                           ? is_covered(map, navigator_->teaches(), *localising_->seed, kSeedHops)
                           : !map.window.places.empty();
  if ((!replica_.is_settled() || !covered) && now < localising_->deadline) return;
  const bool empty =
      map.window.places.empty() || (localising_->seed.has_value() && map.window.place(*localising_->seed) == nullptr);
  if (empty) {
    const std::optional<CommandKey> asked_by = localising_->asked_by;
    const std::string what =
        localising_->seed.has_value() ? "the map around " + to_string(*localising_->seed) : "any part of the network";
    localising_.reset();
    if (asked_by.has_value())
      refuse(*asked_by, what + " did not arrive in 20 s: teach first, or check `weft map info`");
    return;
  }
  localising_->seeking = true;
  localising_->deadline = now + kSearchAtMost;
  if (localising_->believes) return navigator_->look_again();
  navigator_->seek(localising_->seed);
}

/// Begins a search by a robot that may be mistaken, and goes on believing what it believes.
void RobotAgent::look_again(SteadyTime now) {
  searched_at_ = replica_.window().revision;
  search_at_ = now + kBetweenSearches;
  localising_ = Localising{.asked_by = {}, .seed = {}, .believes = true, .deadline = now + kMapAtMost};
}

/// Gives a route back that lies elsewhere, a few times for a goal: then the route fails, and says why.
void RobotAgent::give_back_route(SteadyTime now) {
  constexpr int kMost = 3;
  if (!strays_ || !task_.route().has_value()) return;
  const GoalId goal = task_.route()->goal;
  times_strayed_ = goal == strayed_ ? times_strayed_ + 1 : 1;
  strayed_ = goal;
  if (times_strayed_ > kMost) return;
  output_.notes.push_back("it found itself off its route: it asks for another one from where it stands");
  strays_ = false;
  task_.give_back();
  navigator_->stop();
  command_ = Twist{};
  follow_pending_ = false;
  state_at_ = now;
}

void RobotAgent::note_fix(const Fix& fix, SteadyTime now) {
  output_.fixes.push_back({.frame = frame_, .fix = fix});
  if (teaching_.has_value() && teaching_->phase == Teaching::Phase::seeking) return start_hand();
  if (!localising_.has_value() || !localising_->seeking) return;
  const std::optional<CommandKey> asked_by = localising_->asked_by;
  const bool believed = localising_->believes;
  localising_.reset();
  if (believed) give_back_route(now);
  if (!asked_by.has_value()) return;
  msg::AgentReply done;
  done.done = true;
  done.place = fix.place;
  reply(*asked_by, done);
}

/// Returns whether a search of its own accord is due. A robot that does not know where it is looks once in each
/// revision of the map, and on and on while it has a route; one that may be mistaken looks before a route is planned,
/// and when its route turns out to lie elsewhere. A lost one still has an idea of where it was; the navigator looks
/// from there by itself.
bool RobotAgent::wants_to_look() const {
  const bool is_new = searched_at_ != replica_.window().revision;
  const std::optional<Estimate> estimate = navigator_->estimate();
  if (!estimate.has_value()) return is_new || task_.route().has_value();
  if (lost_ || stopped_) return false;
  return strays_ || (is_new && !task_.route().has_value() && is_far_off(estimate->place_from_robot));
}

void RobotAgent::search_when_of_use(SteadyTime now) {
  if (localising_.has_value() || teaching_.has_value() || !fault_.empty() || now < search_at_) return;
  if (replica_.window().places.empty() || !wants_to_look()) return;
  if (navigator_->estimate().has_value()) return look_again(now);
  start_localising(std::nullopt, std::nullopt, now);
}

void RobotAgent::try_follow(SteadyTime now) {
  waits_for_.clear();
  if (!follow_pending_ || stopped_ || !fault_.empty() || teaching_.has_value()) return;
  if (!navigator_->estimate().has_value()) {
    waits_for_ = "does not know where it is: looks for itself";
    follow_at_latest_ = now + kMapAtMost;
  } else {
    const MapView map = map_view();
    const bool covered = replica_.is_settled() && is_covered(map, *task_.route(), 0, kRouteAhead);
    if (covered || now >= follow_at_latest_) {
      follow_pending_ = false;
      navigator_->follow(*task_.route());
      return;
    }
    waits_for_ = "waits for the map of its route";
  }
  task_.set(msg::RoutePhase::waiting, waits_for_, now);
}

}  // namespace weft::agents
