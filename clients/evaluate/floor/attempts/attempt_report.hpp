#pragma once
#include <string>

#include "clients/evaluate/floor/attempts/attempt_rows.hpp"

namespace weft::evaluate::floor {

/// Returns tables: floor by light with recall and what is wrong, sort of attempt by outcome, and each wrong one.
std::string tables_of(const AttemptRows& rows);

}  // namespace weft::evaluate::floor
