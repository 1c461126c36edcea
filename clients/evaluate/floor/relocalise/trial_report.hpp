#pragma once
#include <filesystem>
#include <string>

#include "agents/bodies/body.hpp"
#include "clients/evaluate/floor/relocalise/trial_rows.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// By floor, light and direction: the share that found itself, median and worst over the seeds, against what is
/// promised (99 and 97 %, none wrong; of floors that repeat: none wrong).
std::string tables_of(const TrialRows& rows);

/// DIR/floor-relocalise.png: the share found within so many metres, and where robots did not find themselves.
Result<void> draw_trials(const TrialRows& rows, const std::vector<agents::SitePoint>& line, const std::string& about,
                         const std::filesystem::path& folder);

}  // namespace weft::evaluate::floor
