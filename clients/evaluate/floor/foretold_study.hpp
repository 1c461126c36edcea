#pragma once
#include "clients/evaluate/floor/subject.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct ForetoldOptions : FloorOptions {
  double contrast = 1.0;  ///< factor on the floors' own; faint ones are what there is to foretell
};

namespace floor {

/// Compares what teaching foretells with what another robot finds. Prints and writes (foretold.md) a row a floor:
/// both shares of places for each condition, over all seeds. The options' light is not looked at: each condition has
/// its own. not_found, invalid: site, line or floor; unavailable: the folder cannot be written.
Result<Ended> study_foretold(const ForetoldOptions& options, const Surroundings& around);

}  // namespace floor
}  // namespace weft::evaluate
