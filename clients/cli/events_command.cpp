#include <algorithm>
#include <chrono>
#include <optional>
#include <tuple>
#include <utility>

#include "clients/cli/commands.hpp"
#include "clients/cli/event_cursor.hpp"
#include "core/text.hpp"
#include "storage/events.hpp"

/// Holds `weft events`: what has happened, and with --follow what happens.
namespace weft::cli {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenAsking = 500ms;
constexpr std::size_t kAtOnce = 1000;  ///< the server gives no more in one answer

/// Asks for events and prints them, each on a line of its own.
class Events {
 public:
  Events(Session& session, const Invocation& invocation, const Output& output)
      : session_(session), invocation_(invocation), output_(output) {}

  Exit run() {
    if (const Result<void> named = learn_names(); !named) return report(named.error(), invocation_.json, output_);
    if (!invocation_.robot.empty() && !robot_) return no_robot();
    const Result<void> shown = begin();
    if (!shown && session_.world().interrupted()) return Exit::done;
    if (!shown) return report(shown.error(), invocation_.json, output_);
    return invocation_.follows ? follow() : Exit::done;
  }

 private:
  Result<void> learn_names() {
    const Result<msg::QueryReply> robots = query_robots(session_, patience(invocation_));
    if (!robots) return fail(robots.error());
    for (auto& [id, name] : names_of(robots->robots)) names_.insert_or_assign(id, name);
    for (const auto& [id, name] : names_) {
      if (name == invocation_.robot || to_string(id) == invocation_.robot) robot_ = id;
    }
    return {};
  }

  Exit no_robot() {
    return report({ErrorCode::refused, "no robot " + invocation_.robot + ": see `weft robots`"}, invocation_.json,
                  output_);
  }

  msg::Query query() const {
    msg::Query query;
    query.kind = msg::Query::Kind::events;
    query.robot = invocation_.robot;
    query.event_kind = invocation_.event_kind;
    query.after_event = cursor_.after();
    query.most = kAtOnce;
    return query;
  }

  /// Shows what has happened: the last few, or all since a time.
  Result<void> begin() {
    msg::Query first = query();
    if (invocation_.since) first.since = invocation_.since->when(session_.world().wall());
    if (!invocation_.since) first.most = invocation_.last;
    while (true) {
      const std::size_t most = first.most;
      Result<msg::QueryReply> reply = session_.query(first, patience(invocation_));
      if (!reply) return fail(reply.error());
      const bool is_all = !invocation_.since || reply->events.size() < most;
      if (!invocation_.since) {
        // The newest are taken as they are: what comes behind them is the rest.
        for (const msg::Event& event : reply->events) show(event);
        cursor_ = EventCursor(reply->newest_event);
        return {};
      }
      show(cursor_.take(*std::move(reply), most));
      if (is_all) return {};
      first.after_event = cursor_.after();
    }
  }

  Exit follow() {
    bool is_silent = false;
    while (!session_.world().interrupted() && output_.out.good()) {
      Result<msg::QueryReply> reply = session_.query(query(), patience(invocation_));
      if (session_.world().interrupted()) break;
      const bool is_refused = !reply && reply.error().code != ErrorCode::timed_out;
      if (is_refused) return report(reply.error(), invocation_.json, output_);
      if (!reply && !is_silent) output_.err << "weft: the server is silent; still following" << std::endl;
      is_silent = !reply;
      show_unkept();
      bool is_all = true;
      if (reply) {
        const EventCursor::Taken taken = cursor_.take(*std::move(reply), kAtOnce);
        show(taken);
        is_all = taken.is_all;
      }
      if (is_all) pause();
    }
    return output_.out.good() ? Exit::done : Exit::failed;
  }

  void pause() {
    const SteadyTime until = session_.world().now() + kBetweenAsking;
    while (session_.world().now() < until && !session_.world().interrupted()) session_.listen(until);
    show_unkept();
  }

  void show_unkept() {
    const storage::EventFilter wanted = {
        .goal = {}, .robot = robot_.value_or(RobotId{}), .kind = invocation_.event_kind, .since = {}, .after = 0};
    for (const msg::Event& event : session_.take_unkept()) {
      if (storage::fits(wanted, event)) show(event);
    }
  }

  void show(const EventCursor::Taken& taken) {
    if (!taken.lost.empty()) {
      output_.err << "weft: " << taken.lost << std::endl;
      if (invocation_.json) output_.out << printed(nlohmann::json{{"lost", taken.lost}}, -1) << std::endl;
    }
    for (const msg::Event& event : taken.events) show(event);
  }

  void show(const msg::Event& event) {
    if (event.robot && !names_.contains(event.robot)) {
      std::ignore = learn_names();
      names_.try_emplace(event.robot);  // one that was forgotten is asked for once
    }
    if (invocation_.json) {
      output_.out << printed(to_json(event, names_), -1) << std::endl;
      return;
    }
    std::string about = event.who.empty() ? "" : "who " + event.who;
    const auto add = [&about](const std::string& text) { about += (about.empty() ? "" : ", ") + text; };
    if (event.robot) add("robot " + name_of(names_, event.robot));
    if (event.goal) add("goal " + to_string(event.goal).substr(0, 8));
    if (event.number == 0) add("not kept");
    output_.out << iso_time(event.at) << "  " << event.kind << (event.cause.empty() ? "" : ": " + event.cause)
                << (about.empty() ? "" : "  (" + about + ")") << std::endl;
  }

  Session& session_;
  const Invocation& invocation_;
  const Output& output_;
  Names names_;
  std::optional<RobotId> robot_;
  EventCursor cursor_;
};

}  // namespace

Exit run_events(Session& session, const Invocation& invocation, const Output& output) {
  return Events(session, invocation, output).run();
}

}  // namespace weft::cli
