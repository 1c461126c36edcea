#include "server/base/next_map.hpp"

#include <cstddef>
#include <type_traits>
#include <variant>

#include "core/network/apart.hpp"
#include "core/network/change.hpp"
#include "core/network/registrations.hpp"
#include "core/network/removal.hpp"
#include "core/network/rules.hpp"

namespace weft::server {
namespace {

template <class Change>
constexpr bool kChangesMap =
    std::is_same_v<Change, storage::AppendBatch> || std::is_same_v<Change, storage::PutPlaces> ||
    std::is_same_v<Change, storage::PutLabel> || std::is_same_v<Change, storage::PutApart> ||
    std::is_same_v<Change, storage::PutRule> || std::is_same_v<Change, storage::PutRegistration> ||
    std::is_same_v<Change, storage::SealExperience> || std::is_same_v<Change, storage::TakeOut> ||
    std::is_same_v<Change, storage::BringBack> || std::is_same_v<Change, storage::RollBack>;

/// Makes one change upon the map in memory; none where places come back that only the store has.
struct Applied {
  const Snapshot& map;

  std::optional<Snapshot> operator()(const storage::AppendBatch& append) const { return with(map, append.batch); }
  std::optional<Snapshot> operator()(const storage::SealExperience& seal) const {
    return with_seal(map, seal.experience, seal.reason);
  }
  std::optional<Snapshot> operator()(const storage::TakeOut& out) const { return without(map, out.what); }
  std::optional<Snapshot> operator()(const storage::PutLabel& put) const {
    if (map.place(put.place) == nullptr) return std::nullopt;
    return with_label(map, put.label, put.place);
  }
  std::optional<Snapshot> operator()(const storage::PutApart& put) const {
    if (!is_served(map, put.apart)) return std::nullopt;
    return put.holds ? with_apart(map, put.apart) : without_apart(map, put.apart);
  }
  std::optional<Snapshot> operator()(const storage::PutRule& put) const {
    return put.holds ? with_rule(map, put.rule) : without_rule(map, put.rule.name);
  }
  std::optional<Snapshot> operator()(const storage::PutRegistration& put) const {
    return put.holds ? with_registration(map, put.registration) : without_registration(map, put.registration.plan);
  }
  template <class Other>
  std::optional<Snapshot> operator()(const Other& /*change*/) const {
    return std::nullopt;
  }
};

}  // namespace

std::optional<Snapshot> next_map(const Snapshot& map, const storage::Transaction& transaction) {
  std::optional<std::size_t> only;
  for (std::size_t at = 0; at < transaction.changes.size(); ++at) {
    const bool changes_map = std::visit(
        [](const auto& change) { return kChangesMap<std::decay_t<decltype(change)>>; }, transaction.changes[at]);
    if (!changes_map) continue;
    if (only) return std::nullopt;
    only = at;
  }
  if (!only) return std::nullopt;
  return std::visit(Applied{map}, transaction.changes[*only]);
}

}  // namespace weft::server
