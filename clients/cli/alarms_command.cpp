#include <algorithm>

#include "clients/cli/commands.hpp"
#include "core/text.hpp"

/// Holds `weft alarms`: what is wrong now, why, and what to do.
namespace weft::cli {
namespace {

nlohmann::json document_of(const msg::Alarm& alarm) {
  const msg::AlarmText& text = msg::text_of(alarm.kind);
  return {{"kind", text.name},
          {"since", iso_time(alarm.since)},
          {"robot", alarm.robot ? nlohmann::json(alarm.about) : nlohmann::json()},
          {"place", alarm.place ? nlohmann::json(to_string(alarm.place)) : nlohmann::json()},
          {"detail", alarm.detail},
          {"cause", text.cause},
          {"cure", text.cure}};
}

void print(const msg::Alarm& alarm, WallTime now, std::ostream& out) {
  const msg::AlarmText& text = msg::text_of(alarm.kind);
  out << text.name << ": " << alarm.about << ", since " << iso_time(alarm.since) << " ("
      << minutes_text(std::max(0.0, seconds(now - alarm.since))) << ")";
  if (alarm.place) out << ", at " << to_string(alarm.place);
  out << '\n';
  if (!alarm.detail.empty()) out << "  " << one_line(alarm.detail) << '\n';
  out << "  cause: " << text.cause << "\n  cure: " << text.cure << '\n';
}

}  // namespace

Exit run_alarms(Session& session, const Invocation& invocation, const Output& output) {
  msg::Query query;
  query.kind = msg::Query::Kind::alarms;
  const Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  if (invocation.json) {
    nlohmann::json document = {{"alarms", nlohmann::json::array()}};
    for (const msg::Alarm& alarm : reply->alarms) document["alarms"].push_back(document_of(alarm));
    output.out << printed(document) << '\n';
  } else {
    for (const msg::Alarm& alarm : reply->alarms) print(alarm, session.world().wall(), output.out);
    if (reply->alarms.empty()) output.out << "no alarms\n";
  }
  return reply->alarms.empty() ? Exit::done : Exit::failed;
}

}  // namespace weft::cli
