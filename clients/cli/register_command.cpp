#include <algorithm>
#include <array>
#include <iterator>

#include "clients/cli/commands.hpp"
#include "clients/cli/plan_layer.hpp"
#include "clients/cli/registered.hpp"
#include "clients/cli/table.hpp"
#include "core/names.hpp"
#include "core/text.hpp"

/// Holds the command that registers floor plans to the map, and shows and removes what is registered.
namespace weft::cli {
namespace {

using Kind = msg::OperatorRequest::Kind;
using State = msg::RegistrationRow::PickState;

const char* words_of(State state) {
  switch (state) {
    case State::counts:
      return "counts";
    case State::left_out:
      return "left out";
    case State::gone:
      return "gone";
  }
  return "unknown";
}

/// Refuses a pick that is not on the plan: pixels were given, say, or x and y exchanged.
Result<void> check_on_plan(const formats::FloorPlan& plan, const std::string& file, const Anchor& pick) {
  const Eigen::Vector2d in_grid = plan.plan_from_grid.inverse() * pick.position;
  const bool is_on = in_grid.x() >= 0.0 && in_grid.x() <= plan.width * plan.cell_m && in_grid.y() >= 0.0 &&
                     in_grid.y() <= plan.height * plan.cell_m;
  if (is_on) return {};
  const std::array<Pose2, 4> corners = corners_of(plan);
  const auto [left, right] = std::ranges::minmax(corners, {}, &Pose2::x);
  const auto [below, above] = std::ranges::minmax(corners, {}, &Pose2::y);
  return fail(ErrorCode::invalid,
              "--pick " + pick.label + "=" + short_number(pick.position.x()) + "," + short_number(pick.position.y()) +
                  " lies outside of " + file + ", which has x " + fixed(left.x, 2) + " to " + fixed(right.x, 2) +
                  " and y " + fixed(below.y, 2) + " to " + fixed(above.y, 2) + " m: give metres in the plan's frame");
}

Result<Pick> pick_of(const Anchor& given, double sigma_m, const NetworkPage& page) {
  Pick pick;
  pick.name = given.label;
  pick.on_plan = given.position;
  pick.heading = given.heading;
  pick.sigma_m = sigma_m;
  if (const std::optional<PlaceId> place = parse_place_id(given.label)) {
    pick.place = *place;
    return pick;
  }
  const auto label = page.labels.find(given.label);
  if (label == page.labels.end()) {
    return fail(ErrorCode::not_found, "--pick " + given.label +
                                          ": the map has no such label; weft map list shows "
                                          "labels, weft map label makes one");
  }
  pick.place = label->second;
  return pick;
}

Result<msg::OperatorRequest> register_request(const Invocation& invocation, const NetworkPage& page,
                                              const Output& output) {
  msg::OperatorRequest request;
  request.kind = Kind::plan_register;
  request.work.only_say = invocation.only_say;
  request.registration.plan = plan_name(invocation.floor_plan);
  if (const Result<void> good = check_name("plan", request.registration.plan); !good) return fail(good.error());
  if (invocation.anchors.size() > kMostPicks) {
    return fail(ErrorCode::invalid, std::to_string(invocation.anchors.size()) + " picks are given, at most " +
                                        std::to_string(kMostPicks) + " can be: leave some out");
  }
  const Result<formats::FloorPlan> plan = read_floor_plan(invocation.floor_plan, output.err);
  if (!plan) return fail(plan.error());
  const Result<ContentHash> hash = plan_hash(invocation.floor_plan);
  if (!hash) return fail(hash.error());
  request.registration.plan_hash = *hash;
  for (const Anchor& given : invocation.anchors) {
    if (const Result<void> on = check_on_plan(*plan, invocation.floor_plan, given); !on) return fail(on.error());
    Result<Pick> pick = pick_of(given, invocation.sigma_m, page);
    if (!pick) return fail(pick.error());
    request.registration.picks.push_back(*std::move(pick));
  }
  return request;
}

nlohmann::json document_of(const msg::RegistrationRow& row) {
  nlohmann::json document = {{"plan", row.registration.plan},
                             {"sha256", to_string(row.registration.plan_hash)},
                             {"places", row.places},
                             {"all_places", row.all_places},
                             {"scale", row.scale},
                             {"sigma_m", row.sigma_m},
                             {"text", row.text},
                             {"problem", row.problem.empty() ? nlohmann::json() : nlohmann::json(row.problem)},
                             {"picks", nlohmann::json::array()}};
  for (std::size_t at = 0; at < row.registration.picks.size(); ++at) {
    const Pick& pick = row.registration.picks[at];
    nlohmann::json one = {{"name", pick.name},     {"place", to_string(pick.place)}, {"x", pick.on_plan.x()},
                          {"y", pick.on_plan.y()}, {"sigma_m", pick.sigma_m},        {"state", nullptr},
                          {"off_m", nullptr}};
    one["heading"] = pick.heading ? nlohmann::json(*pick.heading) : nlohmann::json();
    if (at < row.picks.size()) one["state"] = words_of(row.picks[at].state);
    if (at < row.picks.size() && row.picks[at].state != State::gone) one["off_m"] = row.picks[at].off_m;
    document["picks"].push_back(std::move(one));
  }
  return document;
}

void print(const msg::RegistrationRow& row, const Output& output) {
  output.out << "plan " << row.registration.plan << ": " << (row.problem.empty() ? row.text : row.problem) << '\n';
  if (row.problem.empty()) {
    output.out << row.places << " of " << row.all_places << " places lie on it";
    if (row.places < row.all_places) output.out << "; those of parts without picks have no pose there";
    output.out << '\n';
  }
  Table table;
  table.add({"PICK", "PLACE", "ON PLAN", "OFF", "STATE"});
  for (std::size_t at = 0; at < row.registration.picks.size(); ++at) {
    const Pick& pick = row.registration.picks[at];
    const bool is_known = at < row.picks.size();
    table.add({pick.name, to_string(pick.place), fixed(pick.on_plan.x(), 2) + "," + fixed(pick.on_plan.y(), 2),
               is_known && row.picks[at].state != State::gone ? fixed(row.picks[at].off_m, 2) + " m" : "-",
               is_known ? words_of(row.picks[at].state) : "-"});
  }
  table.print(output.out);
}

/// Returns the row of the plan that PLAN names, or all rows when it names none. not_found: the plan is not
/// registered.
Result<std::vector<msg::RegistrationRow>> rows_to_show(const std::vector<msg::RegistrationRow>& all,
                                                       const std::string& file) {
  if (file.empty()) return all;
  std::vector<Registration> known;
  for (const msg::RegistrationRow& row : all) known.push_back(row.registration);
  const Result<Registration> wanted = registration_of(known, plan_name(file));
  if (!wanted) return fail(wanted.error());
  std::vector<msg::RegistrationRow> rows;
  std::ranges::copy_if(all, std::back_inserter(rows),
                       [&](const msg::RegistrationRow& row) { return row.registration.plan == wanted->plan; });
  return rows;
}

Exit show_registrations(Session& session, const Invocation& invocation, const Output& output) {
  msg::Query query;
  query.kind = msg::Query::Kind::registrations;
  const Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  const Result<std::vector<msg::RegistrationRow>> rows = rows_to_show(reply->registrations, invocation.floor_plan);
  if (!rows) return report(rows.error(), invocation.json, output);
  if (invocation.json) {
    nlohmann::json document = {{"registrations", nlohmann::json::array()}};
    for (const msg::RegistrationRow& row : *rows) document["registrations"].push_back(document_of(row));
    output.out << printed(document) << '\n';
    return Exit::done;
  }
  for (const msg::RegistrationRow& row : *rows) print(row, output);
  if (rows->empty()) output.out << "no floor plan is registered: weft map register PLAN.yaml --pick LABEL=X,Y\n";
  return Exit::done;
}

}  // namespace

Exit run_register(Session& session, const Invocation& invocation, const Output& output) {
  if (invocation.lists) return show_registrations(session, invocation, output);
  msg::OperatorRequest request;
  request.kind = Kind::plan_remove;
  request.work.only_say = invocation.only_say;
  request.registration.plan = plan_name(invocation.floor_plan);
  if (!invocation.removes) {
    const Result<NetworkPage> page = last_page_at(session, invocation, {});
    if (!page) return report(page.error(), invocation.json, output);
    Result<msg::OperatorRequest> made = register_request(invocation, *page, output);
    if (!made) return report(made.error(), invocation.json, output);
    request = *std::move(made);
  }
  const Result<msg::OperatorReply> reply = session.ask(std::move(request), patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  return show(*reply, invocation, output);
}

}  // namespace weft::cli
