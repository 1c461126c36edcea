#include "tests/storage/random_history.hpp"

#include <algorithm>

#include "core/network/registrations.hpp"
#include "core/network/rules.hpp"

namespace weft::storage::sample {

PlaceId RandomHistory::pick(const Snapshot& now) {
  std::vector<PlaceId> places;
  for (const auto& [id, experience] : now.experiences()) {
    for (const Place& place : experience->places) places.push_back(place.id);
  }
  return places.empty() ? PlaceId{} : places[random_.below(places.size())];
}

std::optional<RandomHistory::Step> RandomHistory::draw_batch(const Snapshot& now, const PlaceId& joined) {
  if (runs_.empty() || random_.below(4) == 0) {
    runs_.emplace_back(next_run_, 100 + next_run_);
    ++next_run_;
  }
  Run& run = runs_[random_.below(runs_.size())];
  auto delivery = run.next(1 + static_cast<std::uint32_t>(random_.below(4)));
  if (joined.experience && joined.experience != run.experience()) {
    delivery.batch.edges.push_back(stitch(joined, delivery.batch.places.back().id));
  }
  if (joined.experience && joined.experience != run.experience() && random_.below(2) == 0) {
    const Bytes better = content(random_, 150);
    delivery.batch.learned.push_back(known_anew(*now.place(joined), better, delivery.batch.robot));
    delivery.contents.push_back(better);
  }
  if (!check(now, delivery.batch).empty()) {  // a rollback or a removal has ended it
    std::erase_if(runs_, [&](const Run& one) { return one.experience() == delivery.batch.experience; });
    return std::nullopt;
  }
  return Step{sample::transaction(delivery), with(now, delivery.batch)};
}

RandomHistory::Step RandomHistory::draw_removal(const Snapshot& now, const PlaceId& place) {
  const Experience& experience = *now.experience(place.experience);
  const std::uint32_t last =
      std::min(place.index + static_cast<std::uint32_t>(random_.below(3)), experience.extent - 1);
  Removal removal{{{place.experience, place.index, last}}, {}};
  if (!experience.stitches.empty()) {
    removal.stitches.push_back(experience.stitches[random_.below(experience.stitches.size())].id);
  }
  out_.push_back(removal);
  return {{{TakeOut{removal}}, {}}, without(now, removal)};
}

/// Draws a step that records that two places are different floors, or now and then removes such a record.
std::optional<RandomHistory::Step> RandomHistory::draw_apart(const Snapshot& now, const PlaceId& one) {
  const PlaceId other = pick(now);
  const Apart apart = ordered({{one.experience, one.index, one.index}, {other.experience, other.index, other.index}});
  if (!now.aparts().empty() && random_.below(3) == 0) {
    const Apart& known = now.aparts()[random_.below(now.aparts().size())];
    return Step{{{PutApart{known, false}}, {}}, without_apart(now, known)};
  }
  if (!check(now, apart)) return std::nullopt;
  return Step{{{PutApart{apart}}, {}}, with_apart(now, apart)};
}

RandomHistory::Step RandomHistory::draw_rule(const Snapshot& now, const PlaceId& place) {
  Rule rule;
  rule.name = "rule" + std::to_string(random_.below(3));
  if (now.rules().contains(rule.name) && random_.below(2) == 0) {
    return {{{PutRule{rule, false}}, {}}, without_rule(now, rule.name)};
  }
  rule.kind = RuleKind::speed;
  rule.value = 0.25 * static_cast<double>(1 + random_.below(4));
  rule.spans = {{place, place}};
  if (rule.value > 0.5) rule.area = Area{"plan0", {}, {{0, 0}, {rule.value, 0}, {0, 1}}};
  return {{{PutRule{rule}}, {}}, with_rule(now, rule)};
}

RandomHistory::Step RandomHistory::draw_registration(const Snapshot& now, const PlaceId& place) {
  Registration registration;
  registration.plan = "plan" + std::to_string(random_.below(3));
  if (now.registrations().contains(registration.plan) && random_.below(2) == 0) {
    return {{{PutRegistration{registration, false}}, {}}, without_registration(now, registration.plan)};
  }
  Pick pick;
  pick.name = "some";
  pick.place = place;
  pick.on_plan.x() = 0.25 * static_cast<double>(random_.below(100));
  pick.heading = 0.5;
  registration.picks = {pick};
  return {{{PutRegistration{registration}}, {}}, with_registration(now, registration)};
}

std::optional<RandomHistory::Step> RandomHistory::draw(const Snapshot& now, Revision oldest) {
  const std::uint64_t kind = random_.below(10);
  const PlaceId some = pick(now);
  if (kind < 5 || !some.experience) return draw_batch(now, some);
  if (kind == 5) {
    const std::uint64_t word = random_.below(5);
    if (word < 2) return draw_apart(now, some);
    if (word == 2) return draw_rule(now, some);
    if (word == 3) return draw_registration(now, some);
    const std::string label = "label" + std::to_string(random_.below(3));
    return Step{{{PutLabel{label, some}}, {}}, with_label(now, label, some)};
  }
  if (kind < 8) return draw_removal(now, some);
  if (kind == 8 && !out_.empty()) return Step{{{BringBack{out_[random_.below(out_.size())]}}, {}}, std::nullopt};
  if (now.revision() <= oldest) return std::nullopt;
  const std::uint64_t to = oldest.value + random_.below(now.revision().value - oldest.value);
  return Step{{{RollBack{{to}}}, {}}, std::nullopt};
}

}  // namespace weft::storage::sample
