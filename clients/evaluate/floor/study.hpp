#pragma once
#include "clients/evaluate/floor/subject.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Measures what is not in the output folder yet, keeps each row as soon as it is there, and at the end prints the
/// tables and writes floor.csv and floor.json. not_found, invalid: site, line, floor or light; conflict: the folder
/// holds another study; unavailable: it cannot be written.
Result<Ended> study_floor(const FloorOptions& options, const Surroundings& around);

}  // namespace weft::evaluate::floor
