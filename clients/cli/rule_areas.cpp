#include "clients/cli/rule_areas.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "clients/cli/registered.hpp"
#include "core/network/rules.hpp"

namespace weft::cli {
namespace {

/// Makes a snapshot of the network, as far as a rule's extent depends on it: places, edges and labels.
Snapshot snapshot_of(const Window& network) {
  std::map<ExperienceId, std::vector<Place>> places;
  std::map<ExperienceId, std::vector<Edge>> chains;
  std::map<ExperienceId, Experience> runs;
  for (const auto& [id, place] : network.places) places[id.experience].push_back(place);
  for (const auto& [id, edge] : network.edges) {
    if (edge.origin != Origin::stitch) {
      chains[id.a.experience].push_back(edge);
      continue;
    }
    const auto stitch = std::make_shared<const Edge>(edge);
    runs[id.a.experience].stitches.push_back(stitch);
    if (id.a.experience != id.b.experience) runs[id.b.experience].stitches.push_back(stitch);
  }
  Snapshot::Experiences experiences;
  for (auto& [id, row] : places) {
    Experience& run = runs[id];
    run.id = id;
    run.extent = row.back().id.index + 1;
    run.places = SharedRow<Place>(std::move(row));
    run.chain = SharedRow<Edge>(std::move(chains[id]));
    index_stitches(run);
    experiences[id] = std::make_shared<const Experience>(std::move(run));
  }
  return {network.revision, std::move(experiences), std::make_shared<const Snapshot::Labels>(network.labels)};
}

Result<Layout> laid_out(const Window& network, const Registration& plan) {
  Result<Registered> on_plan = registered(network, plan);
  if (!on_plan) return fail(on_plan.error());
  return std::move(on_plan->layout);
}

}  // namespace

Result<Area> RuleAreas::area_on(const std::string& plan, const Polygon& corners) const {
  const Result<Registration> found = registration_of(plans_, plan);
  if (!found) return fail(found.error());
  return Area{found->plan, found->plan_hash, corners};
}

Result<const Layout*> RuleAreas::layout_on(const Area& area) {
  const auto plan = std::ranges::find(plans_, area.plan, &Registration::plan);
  if (plan == plans_.end()) {
    return fail(ErrorCode::not_found, "plan " + area.plan +
                                          ", on which its area lies, is no longer registered: weft map register " +
                                          area.plan + ".yaml --pick LABEL=X,Y, or lay the rule down again");
  }
  if (plan->plan_hash != area.plan_hash) {
    return fail(ErrorCode::refused, "plan " + area.plan +
                                        " is registered from another file, or picture, than its area was laid down "
                                        "on: lay the rule down again with --polygon");
  }
  auto known = layouts_.find(area.plan);
  if (known == layouts_.end()) known = layouts_.emplace(area.plan, laid_out(network_, *plan)).first;
  if (!known->second) return fail(known->second.error());
  return &*known->second;
}

Result<std::vector<Span>> RuleAreas::spans_of(const Area& area) {
  const Result<const Layout*> layout = layout_on(area);
  if (!layout) return fail(layout.error());
  return spans_within(**layout, area.corners);
}

Result<std::size_t> RuleAreas::not_covered(const Rule& rule) {
  if (!rule.area) return std::size_t{0};
  const Result<const Layout*> layout = layout_on(*rule.area);
  if (!layout) return fail(layout.error());
  if (!map_) map_ = snapshot_of(network_);
  const std::vector<PlaceId> covered = extent_of(*map_, rule).places;
  const std::set<PlaceId> within = places_within(**layout, rule.area->corners);
  return static_cast<std::size_t>(std::ranges::count_if(
      within, [&](const PlaceId& place) { return !std::ranges::binary_search(covered, place); }));
}

Result<RuleAreas> rule_areas(Session& session, const Invocation& invocation, const Output& output) {
  Result<Window> network = network_at(session, invocation, {}, output);
  if (!network) return fail(network.error());
  Result<NetworkPage> page = last_page_at(session, invocation, network->revision);
  if (!page) return fail(page.error());
  return RuleAreas(*std::move(network), std::move(page->registrations));
}

std::set<PlaceId> places_of(const std::vector<Span>& spans) {
  std::set<PlaceId> places;
  for (const Span& span : spans) {
    places.insert({span.from, span.to});
    if (span.from.experience != span.to.experience) continue;
    const auto [low, high] = std::minmax(span.from.index, span.to.index);
    for (std::uint32_t index = low; index < high; ++index) places.insert({span.from.experience, index});
  }
  return places;
}

std::vector<Span> spans_of(const std::set<PlaceId>& places) {
  std::vector<Span> spans;
  for (const PlaceId& place : places) {
    const bool goes_on =
        !spans.empty() && spans.back().to.experience == place.experience && spans.back().to.index + 1 == place.index;
    if (goes_on) {
      spans.back().to = place;
    } else {
      spans.push_back({place, place});
    }
  }
  return spans;
}

}  // namespace weft::cli
