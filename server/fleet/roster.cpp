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
  const auto stored = context_.writer.commit({{storage::PutRobot{id, ""}, storage::PutEvent{event}}, {}}, now);
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

}  // namespace weft::server
