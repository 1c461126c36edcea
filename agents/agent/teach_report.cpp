#include "agents/agent/teach_report.hpp"

#include <utility>

#include "agents/agent/replies.hpp"

namespace weft::agents {
namespace {

double found(const TaughtStretch& row, Prospect prospect) {
  return row.found[static_cast<std::size_t>(prospect)];
}

}  // namespace

Result<msg::AgentReply> teach_report(const Navigator& navigator, const std::string& robot, const std::string& name) {
  const Result<TaughtWay> way = navigator.taught_way();
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
                           .as_is = found(row, Prospect::as_is),
                           .half_light = found(row, Prospect::half_light),
                           .worn = found(row, Prospect::worn),
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
