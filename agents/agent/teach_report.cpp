#include "agents/agent/teach_report.hpp"

#include <utility>

#include "agents/agent/replies.hpp"

namespace weft::agents {
Result<msg::AgentReply> teach_report(const Navigator& navigator, const std::string& robot, const std::string& name) {
  const Result<TeachReport> way = navigator.teach_report();
  if (!way) return fail(way.error());
  if (!name.empty() && name != to_string(way->experience)) {
    return fail(ErrorCode::refused, robot + " reports on what it was taught last, experience " +
                                        to_string(way->experience) + ": leave the name out");
  }
  msg::AgentReply done = carried_out();
  done.experience = way->experience;
  for (TaughtStretch& row : stretches_of(*way, msg::kReportRows)) {
    done.report.push_back({.from_m = row.from_m,
                           .to_m = row.to_m,
                           .places = row.places,
                           .first = row.first,
                           .found = std::move(row.found),
                           .sigma_m = row.sigma_m,
                           .reason = std::move(row.reason)});
  }
  if (done.report.empty()) {
    return fail(ErrorCode::refused,
                robot + " has not tried any of its places yet: lead it on for half a metre, ask again");
  }
  return done;
}

}  // namespace weft::agents
