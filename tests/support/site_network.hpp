#pragma once
#include "clients/evaluate/generate/site_generator.hpp"
#include "storage/network_builder.hpp"

namespace weft::support {

using TruePoses = std::vector<std::pair<PlaceId, Pose2>>;  ///< site_from_place

/// Returns the generated site as a snapshot, at the revision that its batches would have led to. Takes linear time.
inline Snapshot make_site(const SitePlan& plan, TruePoses* truth = nullptr) {
  SiteGenerator generator(plan);
  storage::NetworkBuilder builder;
  std::map<ExperienceId, storage::NetworkBuilder::Head> heads;
  std::uint64_t revision = 0;
  while (!generator.is_done()) {
    Batch batch = generator.next();
    auto& head = heads[batch.experience];
    head = {batch.experience,
            batch.robot,
            batch.name,
            batch.method,
            batch.seal,
            batch.seal_reason,
            head.places + batch.places.size()};
    for (std::size_t at = 0; truth != nullptr && at < batch.places.size(); ++at) {
      truth->emplace_back(batch.places[at].id, generator.poses()[at]);
    }
    for (Place& place : batch.places) builder.add(std::move(place));
    for (Edge& edge : batch.edges) builder.add(std::move(edge));
    ++revision;
  }
  for (const auto& [id, head] : heads) builder.add(head);
  for (const auto& [label, place] : generator.labels()) builder.add_label(label, place);
  return builder.build(Revision{revision});
}

}  // namespace weft::support
