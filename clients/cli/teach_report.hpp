#pragma once
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Returns what a condition is called in sentences: "in half the light"; of one that this program does not know, its
/// name.
std::string words_for(const std::string& condition);

/// Returns what to do before the robot leaves: a sentence for each run of stretches that will not be found, with its
/// metres, under the mildest condition under which that is so. Empty: nothing needs to be done.
std::vector<std::string> advice_of(const std::vector<msg::TaughtStretch>& report);

/// Prints a row for each stretch, and the advice.
void print_report(const std::vector<msg::TaughtStretch>& report, std::ostream& out);
nlohmann::json to_json(const msg::TaughtStretch& stretch);

/// Draws a line for each condition over the metres taught, as PNG or SVG. exhausted: it cannot be written.
Result<void> draw_report(const std::vector<msg::TaughtStretch>& report, const std::string& about,
                         const std::string& file);

}  // namespace weft::cli
