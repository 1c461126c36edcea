#include "server/traffic/unjoined.hpp"

#include <utility>
#include <vector>

namespace weft::server {
namespace {

constexpr std::size_t kMostNamed = 5;

std::string names_of(const std::vector<RobotId>& robots, const Fleet& fleet) {
  std::string names;
  for (std::size_t i = 0; i < robots.size() && i < kMostNamed; ++i) {
    names += (i == 0 ? "" : ", ") + fleet.name_of(robots[i]);
  }
  if (robots.size() > kMostNamed) names += " and " + std::to_string(robots.size() - kMostNamed) + " more";
  return names;
}

std::string warning_of(const std::vector<std::vector<RobotId>>& parts, const Fleet& fleet, Unjoined policy) {
  if (parts.size() < 2) return {};
  std::string text = "nothing in the map joins the part with " + names_of(parts[0], fleet) + " and that with ";
  text += names_of(parts[1], fleet);
  if (parts.size() > 2) text += " (and " + std::to_string(parts.size() - 2) + " more)";
  text += ": robots of the one do not wait for robots of the other, and may touch them; teach a way that joins them";
  return text + (policy == Unjoined::warn ? ", or set unjoined = one_drives" : "; one robot drives at a time");
}

}  // namespace

void UnjoinedWatch::tick(Now now) {
  if (looked_ == traffic_.parts_version() || traffic_.is_laying_out()) return;
  looked_ = traffic_.parts_version();
  const bool was_told = !warning_.empty();
  warning_ = warning_of(traffic_.by_part(), fleet_, context_.config.unjoined);
  if (was_told == !warning_.empty()) return;
  context_.writer.note({.at = {},
                        .kind = was_told ? "traffic.joined" : "traffic.unjoined",
                        .robot = {},
                        .goal = {},
                        .cause = was_told ? "all robots are in one part of the map" : warning_,
                        .who = "server"},
                       now);
}

}  // namespace weft::server
