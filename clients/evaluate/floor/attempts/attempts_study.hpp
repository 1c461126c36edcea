#pragma once
#include <cstddef>

#include "clients/evaluate/floor/subject.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Holds what is asked for; `out`, `kind`, `light`, `seeds`, ... mean what they mean for any study of floors.
struct AttemptsOptions : FloorOptions {
  std::size_t attempts = 100'000;  ///< of all floors, lights and seeds together
};

namespace floor {

/// Makes attempts row by row (floor, light, seed) until there are as many as asked for; rows that the folder holds
/// are kept. At the end prints the tables and writes attempts.csv, attempts.json and a picture. Errors as of
/// study_floor; refused: some were wrong.
Result<Ended> study_attempts(const AttemptsOptions& options, const Surroundings& around);

}  // namespace floor
}  // namespace weft::evaluate
