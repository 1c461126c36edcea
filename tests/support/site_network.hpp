#pragma once
#include "core/network/site_generator.hpp"
#include "storage/network_builder.hpp"

namespace weft::support {

/// The generated site as a snapshot, at the revision that its batches would have led to. Linear time.
inline Snapshot make_site(const SitePlan& plan) {
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
    for (Place& place : batch.places) builder.add(std::move(place));
    for (Edge& edge : batch.edges) builder.add(std::move(edge));
    ++revision;
  }
  for (const auto& [id, head] : heads) builder.add(head);
  for (const auto& [label, place] : generator.labels()) builder.add_label(label, place);
  return builder.build(Revision{revision});
}

}  // namespace weft::support
