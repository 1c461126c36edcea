#include <algorithm>
#include <utility>

#include "server/fleet/fleet.hpp"

namespace weft::server {
namespace {

constexpr std::size_t kListed = 20;  ///< names in an error

std::string ids_of(const std::vector<const Robot*>& robots) {
  std::string ids;
  for (const Robot* const robot : robots) ids += (ids.empty() ? "" : ", ") + to_string(robot->id);
  return ids;
}

}  // namespace

std::string Fleet::listed() const {
  std::vector<std::string> names;
  for (const auto& [id, robot] : robots_) names.push_back(robot.name.empty() ? to_string(id) : robot.name);
  std::sort(names.begin(), names.end());
  const std::size_t more = names.size() - std::min(names.size(), kListed);
  names.resize(names.size() - more);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return more == 0 ? text : text + " and " + std::to_string(more) + " more";
}

Result<RobotId> Fleet::by_name(const std::string& text) const {
  std::vector<const Robot*> named;
  std::vector<const Robot*> heard;
  for (const auto& [id, robot] : robots_) {
    if (robot.name != text) continue;
    named.push_back(&robot);
    if (!robot.silent) heard.push_back(&robot);
  }
  if (heard.size() == 1) return heard.front()->id;
  if (heard.size() > 1) {
    return fail(ErrorCode::refused, std::to_string(heard.size()) + " robots that are heard are named " + text + ": " +
                                        ids_of(heard) + "; name it by its id, or start one with another --name");
  }
  if (named.size() == 1) return named.front()->id;
  if (named.size() > 1) {
    return fail(ErrorCode::refused, std::to_string(named.size()) + " robots are named " + text +
                                        ", and none is heard: " + ids_of(named) +
                                        "; name it by its id, or `weft robot forget ID` those that are gone");
  }
  RobotId id;
  const bool is_id = text.size() == 2 * id.bytes.size() && parse_hex(text, id.bytes.data(), id.bytes.size());
  if (is_id && find(id) != nullptr) return id;
  return fail(ErrorCode::not_found,
              "no robot is named " + text + (robots_.empty() ? "; none was ever heard" : "; known: " + listed()));
}

Result<void> Fleet::forget(const RobotId& id, const std::string& who, Now now) {
  const Robot* const robot = find(id);
  if (robot == nullptr) return fail(ErrorCode::not_found, "there is no robot " + to_string(id));
  if (!robot->silent) return fail(ErrorCode::refused, robot->name + " is heard: end its agent first");
  const msg::Event event = {.at = {},
                            .kind = "robot.forgotten",
                            .robot = id,
                            .goal = {},
                            .cause = name_of(id) + " (" + to_string(id) + ") is forgotten",
                            .who = who};
  const auto stored = context_.writer.commit(
      {{storage::PutRobot{id, ""}, storage::PutHold{id, ""}, storage::PutEvent{event}}, {}}, now);
  if (!stored) return fail(stored.error());
  robots_.erase(id);
  return {};
}

Result<void> Fleet::rename(const RobotId& id, const std::string& name, const std::string& who, Now now) {
  if (const Result<void> good = check_name("robot", name); !good) return good;
  const auto found = robots_.find(id);
  if (found == robots_.end()) return fail(ErrorCode::not_found, "there is no robot " + to_string(id));
  if (!found->second.silent) {
    return fail(ErrorCode::refused,
                found->second.name + " is heard: it is called what its agent was started with (--name)");
  }
  const auto same = std::find_if(robots_.begin(), robots_.end(),
                                 [&](const auto& entry) { return entry.first != id && entry.second.name == name; });
  if (same != robots_.end()) {
    return fail(ErrorCode::refused, "robot " + to_string(same->first) + " is named " + name + " already");
  }
  const msg::Event event = {.at = {},
                            .kind = "robot.renamed",
                            .robot = id,
                            .goal = {},
                            .cause = name_of(id) + " is called " + name + " from now on",
                            .who = who};
  const auto stored = context_.writer.commit({{storage::PutRobot{id, name}, storage::PutEvent{event}}, {}}, now);
  if (!stored) return fail(stored.error());
  found->second.name = name;
  return {};
}

Result<std::string> Fleet::hold(const RobotId& id, bool holds, const std::string& who, Now now) {
  const auto found = robots_.find(id);
  if (found == robots_.end()) return fail(ErrorCode::not_found, "there is no robot " + to_string(id));
  std::string& held_by = found->second.held_by;
  const std::string name = name_of(id);
  if (holds && !held_by.empty()) return fail(ErrorCode::refused, name + " is held already, by " + held_by);
  if (!holds && held_by.empty()) return fail(ErrorCode::refused, "nobody holds " + name);
  const std::string holder = !holds ? std::string() : who.empty() ? std::string("an operator") : who;
  const std::string cause =
      holds ? name + " is released no farther until weft unhold " + name : name + " is held no longer by " + held_by;
  const msg::Event event = {
      .at = {}, .kind = holds ? "robot.held" : "robot.let_go", .robot = id, .goal = {}, .cause = cause, .who = who};
  const auto stored = context_.writer.commit({{storage::PutHold{id, holder}, storage::PutEvent{event}}, {}}, now);
  if (!stored) return fail(stored.error());
  held_by = holder;
  return cause;
}

}  // namespace weft::server
