#include "clients/evaluate/floor/refined_draft.hpp"

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "agents/navigation/run_refiner.hpp"
#include "core/network/codec.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace agents;

/// Returns the run with all amendments made.
Result<std::vector<Kept>> amended(std::vector<Kept> draft, RunAmendments amendments) {
  std::map<EdgeId, Relation> relations;
  std::map<PlaceId, Bytes> contents;
  for (AmendedEdge& one : amendments.edges) relations.insert_or_assign(one.edge, std::move(one.a_from_b));
  for (AmendedPlace<Bytes>& one : amendments.places) contents.insert_or_assign(one.place, std::move(one.content));
  for (Kept& kept : draft) {
    for (Edge& edge : kept.edges) {
      const auto relation = relations.find(edge.id);
      if (relation == relations.end()) continue;
      edge.a_from_b = relation->second;
      relations.erase(relation);
    }
    const auto content = contents.find(kept.place.id);
    if (content == contents.end()) continue;
    kept.content = content->second;
    kept.place.content = {hash_bytes(kept.content), kept.content.size()};
    contents.erase(content);
  }
  if (!relations.empty())
    return fail(ErrorCode::invalid, "refined: the run has no edge from " + to_string(relations.begin()->first.a) +
                                        " to " + to_string(relations.begin()->first.b));
  if (!contents.empty())
    return fail(ErrorCode::invalid, "refined: the run has no place " + to_string(contents.begin()->first));
  return draft;
}

}  // namespace

Result<std::optional<std::vector<Kept>>> refined_draft(const Navigator& navigator, const std::vector<Kept>& draft) {
  const std::unique_ptr<RunRefiner> refiner = navigator.refiner(navigator.method());
  if (!refiner) return std::optional<std::vector<Kept>>();
  for (const Kept& kept : draft)
    if (const Result<void> added = refiner->add(kept); !added) return fail(added.error());
  while (refiner->piece()) {
  }
  Result<std::vector<Kept>> refined = amended(draft, refiner->amendments());
  if (!refined) return fail(refined.error());
  return std::optional(std::move(*refined));
}

}  // namespace weft::evaluate::floor
