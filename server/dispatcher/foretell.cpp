#include "server/dispatcher/dispatcher.hpp"

/// Tells when robots come to their goals.
namespace weft::server {

std::optional<msg::Arrival> Dispatcher::arrival(const Goal& goal) const {
  const auto found = goal.robot ? assignments_.find(*goal.robot) : assignments_.end();
  if (found == assignments_.end() || found->second.goal != goal.id) return std::nullopt;
  const RouteAssignment& assignment = found->second;
  if (assignment.is_to_end() || stays(found->first)) return std::nullopt;
  return arrivals_.foretell(found->first, *book_.route(goal.id));
}

}  // namespace weft::server
