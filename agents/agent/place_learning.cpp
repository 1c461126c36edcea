#include "agents/agent/place_learning.hpp"

#include <utility>

#include "core/network/codec.hpp"

namespace weft::agents {
namespace {
/// Makes one revision of all that one drive has learned, which can be undone as one; a long drive makes several.
constexpr std::size_t kPlacesAtOnce = 500;
}  // namespace

std::size_t PlaceLearning::take(std::vector<LearnedPlace> learned_places, const Window& window, const Seen& seen) {
  std::size_t taken = 0;
  for (LearnedPlace& learned_place : learned_places) {
    const Place* const known = window.place(learned_place.place);
    if (known == nullptr || known->content.hash != learned_place.made_of) continue;
    Place anew = *known;
    ++anew.entity_version;
    anew.content_format = learned_place.content_format;
    anew.content = {hash_bytes(learned_place.content), learned_place.content.size()};
    anew.robot = seen.robot;
    anew.frame = seen.frame;
    anew.seen_at = seen.at;
    learned_.insert_or_assign(learned_place.place, Learned{std::move(anew), std::move(learned_place.content)});
    ++taken;
  }
  return taken;
}

std::string PlaceLearning::hand_in(bool drives, Spooler& spooler, ExperienceIds& ids, SteadyTime now) {
  if (learned_.empty() || (drives && learned_.size() < kPlacesAtOnce)) return {};
  std::vector<Place> places;
  std::vector<Bytes> contents;
  for (auto& [id, learned] : std::exchange(learned_, {})) {
    places.push_back(std::move(learned.place));
    contents.push_back(std::move(learned.content));
  }
  const std::string count = std::to_string(places.size());
  const Result<void> handed_in = spooler.learned(std::move(places), std::move(contents), ids.next(), now);
  return handed_in ? "knows " + count + " places better: handed in"
                   : "what it has learned of " + count + " places is lost: " + handed_in.error().message;
}

}  // namespace weft::agents
