#include "agents/agent/missions/localise_mission.hpp"

#include <utility>

#include "agents/agent/missions/waits.hpp"
#include "agents/agent/surroundings.hpp"

namespace weft::agents {

void LocaliseMission::start(const CommandKey& asked_by, const std::optional<PlaceId>& seed, SteadyTime now) {
  if (search_.has_value() && search_->asked_by.has_value()) {
    uses_.replies.refuse(*search_->asked_by, "another search was asked for meanwhile");
  }
  begin({.asked_by = asked_by, .seed = seed}, now);
}

LocaliseMission::Begun LocaliseMission::search_if_due(const SearchPolicy::Situation& situation, SteadyTime now) {
  if (search_.has_value() || !policy_.is_due(uses_.map.window(), situation, now)) return Begun::nothing;
  const bool believes = situation.estimate.has_value();
  begin({.asked_by = {}, .seed = {}, .is_seeking = false, .believes = believes}, now);
  return believes ? Begun::again : Begun::anew;
}

void LocaliseMission::begin(Search search, SteadyTime now) {
  search.deadline = now + kMapAtMost;
  search_ = search;
  policy_.begins(uses_.map.window(), now);
}

void LocaliseMission::tick(SteadyTime now) {
  if (!search_.has_value()) return;
  if (!search_->is_seeking) return await_map(now);
  if (now >= search_->deadline) give_up();
}

void LocaliseMission::await_map(SteadyTime now) {
  if (!has_enough_map() && now < search_->deadline) return;
  if (has_nothing_to_seek()) {
    const std::string what =
        search_->seed.has_value() ? "the map around " + to_string(*search_->seed) : "any part of the network";
    return end(what + " did not arrive in 20 s: teach first, or check `weft map info`");
  }
  search_->is_seeking = true;
  search_->deadline = now + kSearchAtMost;
  if (search_->believes) return uses_.navigator.look_again();
  uses_.navigator.seek(search_->seed);
}

bool LocaliseMission::has_enough_map() const {
  if (!uses_.map.replica().is_settled()) return false;
  // Without a seed there is something to ask from the first view on, whatever has come of the map.
  if (!search_->seed.has_value()) return !uses_.map.window().places.empty();
  return is_covered(uses_.map.view(), uses_.navigator.teaches(), *search_->seed, kSeedHops);
}

bool LocaliseMission::has_nothing_to_seek() const {
  const Window& window = uses_.map.window();
  return window.places.empty() || (search_->seed.has_value() && window.place(*search_->seed) == nullptr);
}

/// Ends a search that was in vain.
void LocaliseMission::give_up() {
  if (search_->seed.has_value()) uses_.navigator.seek(std::nullopt);
  if (search_->believes) {
    uses_.navigator.stop_looking();
    uses_.map.forget_proposals();
  }
  const std::string likeliest =
      uses_.map.proposals().empty() ? "" : " that look most like what it sees, " + uses_.recogniser.among();
  end(uses_.robot + " did not find itself among " + std::to_string(uses_.map.window().places.size()) + " places" +
      likeliest + ": give --at LABEL, or move it near a place that was taught");
}

void LocaliseMission::end(const std::string& refusal) {
  const std::optional<CommandKey> asked_by = search_->asked_by;
  search_.reset();
  if (asked_by.has_value()) uses_.replies.refuse(*asked_by, refusal);
}

bool LocaliseMission::on_fix(const Fix& fix) {
  if (!search_.has_value() || !search_->is_seeking) return false;
  const Search ended = *std::exchange(search_, std::nullopt);
  if (ended.asked_by.has_value()) {
    msg::AgentReply done = carried_out();
    done.place = fix.place;
    uses_.replies.give(*ended.asked_by, std::move(done));
  }
  return ended.believes;
}

std::string LocaliseMission::describe() const {
  if (!search_.has_value()) return {};
  const Proposals& proposals = uses_.map.proposals();
  if (proposals.empty()) return "looks for itself";
  return "looks for itself among " + std::to_string(proposals.size()) + " places that look like what it sees, " +
         uses_.recogniser.among();
}

std::optional<SteadyTime> LocaliseMission::next() const {
  return search_.has_value() ? std::optional(search_->deadline) : std::nullopt;
}

void LocaliseMission::was_away(Duration away) {
  if (search_.has_value()) search_->deadline += away;
}

}  // namespace weft::agents
