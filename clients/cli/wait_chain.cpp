#include "clients/cli/wait_chain.hpp"

#include <algorithm>

#include "clients/cli/commands.hpp"
#include "clients/cli/table.hpp"

namespace weft::cli {
namespace {

const msg::RobotRow* row_of(const std::vector<msg::RobotRow>& robots, const RobotId& robot) {
  const auto found = std::find_if(robots.begin(), robots.end(),
                                  [&](const msg::RobotRow& row) { return row.description.header.sender == robot; });
  return found == robots.end() ? nullptr : &*found;
}

std::string names(const std::vector<msg::RobotRow>& robots, const std::vector<RobotId>& ids) {
  const Names known = names_of(robots);
  std::string text;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == ids.size() ? " and " : ", ") + name_of(known, ids[i]);
  }
  return text;
}

/// Says what the robot at the end of a chain does instead of waiting.
std::string does(const msg::RobotRow& row) {
  return row.is_heard ? std::string("is ") + msg::to_string(row.state.mode) : "is not heard";
}

}  // namespace

std::vector<const msg::RobotRow*> wait_chain(const std::vector<msg::RobotRow>& robots, const RobotId& robot) {
  std::vector<const msg::RobotRow*> chain;
  const msg::RobotRow* const first = row_of(robots, robot);
  if (first == nullptr || !first->wait.at) return chain;
  chain.push_back(first);
  for (std::size_t at = 0; at < chain.size(); ++at) {
    if (!chain[at]->wait.at) continue;
    for (const RobotId& holder : chain[at]->wait.held_by) {
      const msg::RobotRow* const next = row_of(robots, holder);
      if (next != nullptr && std::find(chain.begin(), chain.end(), next) == chain.end()) chain.push_back(next);
    }
  }
  return chain;
}

std::string chain_text(const std::vector<msg::RobotRow>& robots, const RobotId& robot, WallTime now) {
  std::string text;
  for (const msg::RobotRow* const row : wait_chain(robots, robot)) {
    const std::string& name = row->description.name;
    if (!row->wait.at) {
      text += "  " + name + " " + does(*row) + (row->state.reason.empty() ? "" : ": " + row->state.reason) + "\n";
      continue;
    }
    text += text.empty() ? name : "  " + name;
    text += " waits " + fixed(std::max(0.0, seconds(now - row->wait.since)), 0) + " s at " + to_string(row->wait.at);
    if (!row->wait.held_by.empty()) text += " for " + names(robots, row->wait.held_by);
    if (!row->wait.rule.empty()) text += " as rule " + row->wait.rule + " keeps it";
    if (row->wait.needs) text += ", to have " + to_string(row->wait.needs);
    text += "\n";
  }
  return text;
}

nlohmann::json chain_json(const std::vector<msg::RobotRow>& robots, const RobotId& robot) {
  const Names known = names_of(robots);
  nlohmann::json links = nlohmann::json::array();
  for (const msg::RobotRow* const row : wait_chain(robots, robot)) {
    if (row->wait.at) links.push_back(to_json(row->wait, row->description.name, known));
  }
  return links;
}

std::vector<std::string> standstills(const std::vector<msg::RobotRow>& robots) {
  std::vector<std::string> texts;
  for (const msg::RobotRow& row : robots) {
    const bool is_known = std::find(texts.begin(), texts.end(), row.standstill) != texts.end();
    if (!row.standstill.empty() && !is_known) texts.push_back(row.standstill);
  }
  return texts;
}

}  // namespace weft::cli
