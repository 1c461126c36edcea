#pragma once
#include <filesystem>
#include <string>

#include "clients/evaluate/floor/attempts/attempt_rows.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Tables: floor by light with recall and what is wrong, sort of attempt by outcome, and each wrong one.
std::string tables_of(const AttemptRows& rows);

/// DIR/floor-attempts.png: recall over distance and heading, and why attempts were refused. unavailable.
Result<void> draw_attempts(const AttemptRows& rows, const std::string& about, const std::filesystem::path& folder);

}  // namespace weft::evaluate::floor
