#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/protocol/messages.hpp"
#include "server/context.hpp"
#include "server/dispatcher/goal_book.hpp"
#include "server/fleet/fleet.hpp"
#include "server/intake/intake.hpp"
#include "server/traffic/traffic.hpp"

namespace weft::server {

/// Answers what clients ask to see, in parts of bounded size. Changes nothing.
class Answers {
 public:
  Answers(const Context& context, const Fleet& fleet, const Traffic& traffic, const GoalBook& book,
          const Intake& intake)
      : context_(context), fleet_(fleet), traffic_(traffic), book_(book), intake_(intake) {}

  void on_query(const msg::Query& query, SteadyTime now) const;

 private:
  std::vector<msg::QueryReply> robots(SteadyTime now) const;
  std::vector<msg::QueryReply> goals(const msg::Query& query) const;
  std::vector<msg::QueryReply> events(const msg::Query& query) const;
  std::vector<msg::QueryReply> log(const msg::Query& query) const;
  msg::MapInfo info() const;
  std::string occupies(const RobotId& robot) const;

  const Context& context_;
  const Fleet& fleet_;
  const Traffic& traffic_;
  const GoalBook& book_;
  const Intake& intake_;
};

}  // namespace weft::server
