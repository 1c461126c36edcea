#pragma once
#include "clients/evaluate/floor/subject.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct ForetoldOptions : FloorOptions {
  double contrast = 1.0;  ///< factor on the floors' own; faint ones are what there is to foretell
};

namespace floor {

/// Its light is not looked at: each condition has its own. Prints and writes (foretold.md) a row a floor: for each
/// condition the share of places that teaching foretells and the share that another robot finds, over all seeds.
/// not_found, invalid: site, line or floor; unavailable: the folder cannot be written.
Result<Ended> study_foretold(const ForetoldOptions& options, const Surroundings& around);

}  // namespace floor
}  // namespace weft::evaluate
