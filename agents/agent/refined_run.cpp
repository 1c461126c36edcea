#include "agents/agent/refined_run.hpp"

#include <map>
#include <utility>

#include "core/network/codec.hpp"

namespace weft::agents {
namespace {

/// Makes the amendments in batches, and finds those that are of nothing in them.
class Amending {
 public:
  explicit Amending(RunAmendments amendments) {
    for (AmendedEdge& edge : amendments.edges) edges_.insert_or_assign(edge.edge, std::move(edge.a_from_b));
    for (AmendedPlace<Bytes>& place : amendments.places)
      contents_.insert_or_assign(place.place, std::move(place.content));
  }

  Result<void> amend(Edge& edge) {
    const auto found = edges_.find(edge.id);
    if (found == edges_.end()) return {};
    const std::string of = "refined: the relation of " + to_string(edge.id.a) + " and " + to_string(edge.id.b);
    if (Result<void> checked = check(found->second); !checked)
      return fail(ErrorCode::invalid, of + ": " + checked.error().message);
    if (found->second.index() != edge.a_from_b.index())
      return fail(ErrorCode::invalid, of + " is of another kind than was taught");
    edge.a_from_b = std::move(found->second);
    edges_.erase(found);
    return {};
  }

  void amend(Place& place, std::vector<Bytes>& contents) {
    const auto found = contents_.find(place.id);
    if (found == contents_.end()) return;
    place.content = {hash_bytes(found->second), found->second.size()};
    contents.push_back(std::move(found->second));
    contents_.erase(found);
  }

  Result<void> check_all_made() const {
    if (!edges_.empty()) {
      const EdgeId& edge = edges_.begin()->first;
      return fail(ErrorCode::invalid, "refined: the run has no edge from " + to_string(edge.a) + " to " +
                                          to_string(edge.b) + ", or it was amended already");
    }
    if (contents_.empty()) return {};
    return fail(ErrorCode::invalid, "refined: the run has no place " + to_string(contents_.begin()->first));
  }

 private:
  std::map<EdgeId, Relation> edges_;
  std::map<PlaceId, Bytes> contents_;
};

}  // namespace

Result<RefinedRun> make_refined_run(std::vector<Batch> draft, RunAmendments amendments,
                                    const std::string& seal_reason) {
  RefinedRun run{std::move(draft), {}};
  Amending amending(std::move(amendments));
  for (Batch& batch : run.batches) {
    for (Edge& edge : batch.edges)
      if (Result<void> amended = amending.amend(edge); !amended) return fail(amended.error());
    for (Place& place : batch.places) amending.amend(place, run.contents);
    if (batch.seal) batch.seal_reason = seal_reason;
  }
  if (Result<void> all = amending.check_all_made(); !all) return fail(all.error());
  return run;
}

}  // namespace weft::agents
