#pragma once
#include <algorithm>
#include <cassert>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "agents/methods/method.hpp"
#include "agents/navigation/run_refiner.hpp"

namespace weft::agents {

/// Refines a run with method M, piece by piece.
template <Refines M>
class RunRefinement final : public RunRefiner {
 public:
  /// Takes a method that outlives it.
  explicit RunRefinement(const M& method) : method_(&method) {}

  Result<void> add(const Kept& kept) override {
    Result<typename M::Content> content = method_->decode(kept.content);
    if (!content) return fail(content.error());
    draft_.push_back({kept.place.id, std::make_shared<const typename M::Content>(std::move(*content)), kept.edges});
    return {};
  }

  bool piece() override {
    if (is_done_) return false;
    if (!refinement_) {
      refinement_.emplace(method_->begin_refine(draft_));
      draft_ = {};
      return true;
    }
    is_done_ = !method_->refine(*refinement_);
    ++done_;
    return !is_done_;
  }

  RefineProgress progress() const override {
    if (!refinement_) return {};
    return {done_, std::max(done_, method_->pieces(*refinement_))};
  }

  RunAmendments amendments() override {
    assert(is_done_ && refinement_);
    Amendments<typename M::Content> changes = method_->refined(*std::exchange(refinement_, std::nullopt));
    RunAmendments amendments{std::move(changes.edges), {}};
    amendments.places.reserve(changes.places.size());
    for (const auto& [place, content] : changes.places)
      amendments.places.push_back({place, method_->encode(content)});
    return amendments;
  }

 private:
  const M* method_;
  std::vector<ExperiencePlace<typename M::Content>> draft_;
  std::optional<typename M::Refinement> refinement_;
  std::size_t done_ = 0;
  bool is_done_ = false;
};

}  // namespace weft::agents
