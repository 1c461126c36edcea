#include "agents/agent/run_refining.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

#include "core/network/codec.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

/// Leaves half of the time to the samples, and nine tenths while the robot drives: a piece is reckoned at the most it
/// may take.
constexpr std::uint64_t kPiece_us = 50'000;
constexpr std::uint64_t kMost_us_a_second = 500'000;
constexpr std::uint64_t kMost_us_a_driven_second = 100'000;
constexpr std::uint64_t kMost_us_at_once = 2 * kPiece_us;  ///< what is saved up; a sample gets one piece
constexpr Duration kWithoutSample = 500ms;

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

RunRefining::RunRefining(const Uses& uses, SteadyTime now)
    : uses_(uses),
      budget_(kMost_us_a_second, kMost_us_at_once, now),
      driven_budget_(kMost_us_a_driven_second, kMost_us_at_once, now),
      by_itself_at_(now + kWithoutSample) {}

void RunRefining::begin(ExperienceId experience, const std::string& method) {
  taught_.insert(experience);
  std::unique_ptr<RunRefiner> refiner = uses_.navigator.refiner(method);
  if (refiner == nullptr) return;
  uses_.spooler.hold(experience);
  drafts_.push_back({.experience = experience, .refiner = std::move(refiner)});
}

void RunRefining::add(const Kept& kept) {
  const auto draft = std::ranges::find(drafts_, kept.place.id.experience, &Draft::experience);
  if (draft == drafts_.end()) return;
  const Result<void> added = draft->refiner->add(kept);
  if (added) return;
  uses_.outbox.note("place " + to_string(kept.place.id) +
                    " cannot be refined, its run is handed in as it is taught: " + added.error().message);
  uses_.spooler.release(draft->experience);
  drafts_.erase(draft);
}

void RunRefining::end(ExperienceId experience) {
  taught_.erase(experience);
  if (uses_.spooler.is_held(experience)) return;
  std::erase_if(drafts_, [&](const Draft& draft) { return draft.experience == experience; });
}

bool RunRefining::may_work() const {
  return !drafts_.empty() && taught_.empty();
}

void RunRefining::work(bool is_driving, SteadyTime now) {
  by_itself_at_ = now + kWithoutSample;
  Budget& budget = is_driving ? driven_budget_ : budget_;
  if (may_work() && budget.take(kPiece_us, now)) piece();
}

void RunRefining::tick(SteadyTime now) {
  if (now < by_itself_at_) return;
  by_itself_at_ = now + kWithoutSample;
  if (may_work() && budget_.take(kPiece_us, now)) piece();
}

std::optional<SteadyTime> RunRefining::next() const {
  return may_work() ? std::optional(by_itself_at_) : std::nullopt;
}

void RunRefining::piece() {
  if (drafts_.front().refiner->piece()) return;
  const Draft draft = std::move(drafts_.front());
  drafts_.pop_front();
  hand_in(draft);
}

void RunRefining::hand_in(const Draft& draft) {
  RunAmendments amendments = draft.refiner->amendments();
  const std::string what = counted(amendments.edges.size(), "relation") + " and " +
                           counted(amendments.places.size(), "place") + " amended";
  std::vector<AmendedPlace<Bytes>> places = amendments.places;
  const std::string run = "experience " + to_string(draft.experience);
  const Result<void> done = uses_.spooler.hand_in(draft.experience, std::move(amendments));
  // Also after an error: the spool may have decided for them before.
  for (AmendedPlace<Bytes>& place : places) {
    const ContentHash hash = hash_bytes(place.content);
    uses_.map.put(hash, std::move(place.content));
  }
  if (!done) return uses_.outbox.note(run + " is handed in as the spool has it: " + done.error().message);
  uses_.outbox.note(run + " is refined: " + what);
}

std::string RunRefining::describe() const {
  if (!may_work()) return {};
  const RefineProgress progress = drafts_.front().refiner->progress();
  std::string text = "refines what it was taught: ";
  text += progress.of == 0 ? "begins" : std::to_string(progress.done) + " of " + counted(progress.of, "piece");
  if (drafts_.size() > 1)
    text += "; " + counted(drafts_.size() - 1, "more run") + (drafts_.size() > 2 ? " wait" : " waits");
  return text;
}

}  // namespace weft::agents
