#pragma once
#include <string>
#include <vector>

#include "agents/navigation/run_refiner.hpp"
#include "core/bytes.hpp"
#include "core/network/change.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Holds a run as it is handed in: its batches, and the contents that take the place of those it was taught with.
struct RefinedRun {
  std::vector<Batch> batches;
  std::vector<Bytes> contents;
};

/// Makes the refined run of the draft: the same batches with what was amended, sealed for `seal_reason` if the draft
/// is sealed. invalid: an amendment of what is not in the draft, a relation that is none, or one of another kind.
Result<RefinedRun> make_refined_run(std::vector<Batch> draft, RunAmendments amendments,
                                    const std::string& seal_reason);

}  // namespace weft::agents
