#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "core/network/window.hpp"
#include "core/protocol/messages.hpp"

namespace weft::cli {

/// Holds names of runs (experiences); runs that have none are missing.
using RunNames = std::map<ExperienceId, std::string>;

/// Returns the document as text: always valid, with U+FFFD where a name or a path is no UTF-8.
template <class Json>
std::string printed(const Json& document, int indent = 2) {
  return document.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// Holds robots' names by id, for people.
using Names = std::map<RobotId, std::string>;
std::string name_of(const Names& names, const RobotId& robot);

/// Return JSON documents of what the server answers. A robot's `waits` is {robot, at, needs, held_by, since}, or
/// null.
nlohmann::json to_json(const msg::RobotRow& row, const Names& names);
nlohmann::json to_json(const msg::RobotWait& wait, const std::string& robot, const Names& names);
nlohmann::json to_json(const GoalEvent& event);
/// Returns a goal's document. `route`: the goal's latest one, or null.
nlohmann::json to_json(const Goal& goal, const Route* route, const Names& names, WallTime now);
nlohmann::json to_json(const msg::Arrival& arrival);
nlohmann::json to_json(const msg::Event& event, const Names& names);
nlohmann::json to_json(const msg::MapInfo& info);
/// Returns the document that docs/formats/records.md describes as network.json.
nlohmann::json to_json(const Window& network, const Names& names, const RunNames& runs);
nlohmann::json to_json(const Pose2& pose);

/// Returns how long the goal has taken, from when it was asked for until its end, or until now.
double duration_s(const Goal& goal, WallTime now);
/// Returns a duration to the second, from an hour on to the minute: "2 min 10 s".
std::string minutes_text(double time_s);
/// Returns "arrives in 2 min 10 s (1 min 50 s to 3 min)".
std::string to_text(const msg::Arrival& arrival);

}  // namespace weft::cli
