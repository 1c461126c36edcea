#pragma once
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Of fewer of its places than this a stretch is one where a robot will not find itself.
inline constexpr double kFoundEnough = 0.5;

/// What to do before the robot leaves: a sentence for each run of stretches that will not be found, with its metres,
/// under the mildest prospect under which that is so. Empty: nothing needs to be done.
std::vector<std::string> advice_of(const std::vector<msg::TaughtStretch>& report);

/// A row a stretch, and the advice.
void print_report(const std::vector<msg::TaughtStretch>& report, std::ostream& out);
nlohmann::json to_json(const msg::TaughtStretch& stretch);

/// Three lines over the metres taught, as PNG or SVG. exhausted: it cannot be written.
Result<void> draw_report(const std::vector<msg::TaughtStretch>& report, const std::string& about,
                         const std::string& file);

}  // namespace weft::cli
