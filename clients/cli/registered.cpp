#include "clients/cli/registered.hpp"

#include <algorithm>
#include <filesystem>

#include "clients/cli/export.hpp"
#include "clients/cli/files.hpp"
#include "clients/cli/part_on_plan.hpp"
#include "clients/cli/plan_layer.hpp"
#include "core/network/site_solver.hpp"

namespace weft::cli {
namespace {

using Command = Invocation::Command;

/// Returns whether a picture is of what places show, and not of the network.
bool shows_contents(const Invocation& invocation) {
  return invocation.draws_mosaic || invocation.draws_clouds;
}

/// Returns whether what is written is one of those files that robots' maps and evaluations are compared by, or shows
/// what places show: they are in the plan's frame when there is one.
bool is_for_the_site(const Invocation& invocation) {
  const std::string ending = ending_of(invocation.file);
  return shows_contents(invocation) || is_of_clouds(invocation.file) || ending == ".geojson" || ending == ".tum";
}

std::string known_plans(const std::vector<Registration>& known) {
  std::string text;
  for (const Registration& one : known) text += (text.empty() ? "" : ", ") + one.plan;
  return text.empty() ? "none is" : "known: " + text;
}

Result<Registration> of_name(const std::vector<Registration>& known, const std::string& plan) {
  const auto found = std::ranges::find(known, plan, &Registration::plan);
  if (found != known.end()) return *found;
  return fail(ErrorCode::not_found, "plan " + plan + " is not registered; " + known_plans(known) +
                                        ": weft map register " + plan + ".yaml --pick LABEL=X,Y");
}

/// Returns the registration of the plan that is drawn upon, whose file and picture have to be those that were
/// registered.
Result<std::optional<Registration>> of_floor_plan(const std::vector<Registration>& known, const std::string& file) {
  const Result<Registration> found = of_name(known, plan_name(file));
  if (!found) {
    return fail(found.error().code,
                file + ": " + found.error().message + ", or say with --anchor where the network lies on it");
  }
  const Result<ContentHash> hash = plan_hash(file);
  if (!hash) return fail(hash.error());
  if (*hash == found->plan_hash) return *found;
  return fail(ErrorCode::refused, file + ", or its picture, is not what was registered as plan " + found->plan +
                                      ": register it again, or draw upon that one");
}

}  // namespace

Result<Registration> registration_of(const std::vector<Registration>& known, const std::string& plan) {
  if (!plan.empty()) return of_name(known, plan);
  if (known.size() == 1) return known.front();
  if (known.empty()) {
    return fail(ErrorCode::not_found,
                "no floor plan is registered to the map: weft map register PLAN.yaml --pick LABEL=X,Y");
  }
  return fail(ErrorCode::refused, "several floor plans are registered: say which with --plan; " + known_plans(known));
}

std::string plan_name(const std::string& file) {
  const std::filesystem::path name = std::filesystem::path(file).filename();
  const std::string ending = ending_of(file);
  return (ending == ".yaml" || ending == ".yml" ? name.stem() : name).string();
}

bool wants_plan(const Invocation& invocation) {
  if (!invocation.anchors.empty() || invocation.no_plan) return false;
  if (invocation.command == Command::map_draw && !shows_contents(invocation)) return !invocation.floor_plan.empty();
  return !invocation.plan.empty() || is_for_the_site(invocation);
}

Result<std::optional<Registration>> wanted_registration(const std::vector<Registration>& known,
                                                        const Invocation& invocation) {
  if (!wants_plan(invocation)) return std::nullopt;
  if (invocation.command == Command::map_draw && !shows_contents(invocation))
    return of_floor_plan(known, invocation.floor_plan);
  if (!invocation.plan.empty()) {
    Result<Registration> named = of_name(known, invocation.plan);
    if (!named) return fail(named.error());
    return *std::move(named);
  }
  if (known.empty()) return std::nullopt;
  if (known.size() == 1) return known.front();
  return fail(ErrorCode::refused, invocation.file +
                                      ": several floor plans are registered; say with --plan in whose "
                                      "frame, or --no-plan; " +
                                      known_plans(known));
}

Result<Registered> registered(const Window& network, const Registration& registration) {
  const SiteSolution solution = solve_site(view_of(network), registration);
  if (!solution.problem.empty())
    return fail(ErrorCode::refused, "plan " + registration.plan + ": " + solution.problem);
  PartOnPlan part = part_on_plan(network, [&](const PlaceId& place) { return solution.plan_from_place(place); });
  Registered result{std::move(part.network), std::move(part.layout), part.left_out, {}};
  result.caption = "in the frame of plan " + registration.plan + ", " + to_text(solution);
  if (result.left_out > 0)
    result.caption += ", " + std::to_string(result.left_out) + " places of parts without picks left out";
  return result;
}

}  // namespace weft::cli
