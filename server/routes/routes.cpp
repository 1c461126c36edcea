#include "server/routes/routes.hpp"

#include <algorithm>
#include <chrono>
#include <tuple>
#include <utility>

#include "core/network/no_path.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr std::size_t kMostSets = 4;
constexpr std::size_t kPiece = 1000;  ///< places' worth of work: about 1 ms
constexpr Duration kBetweenRoutePieces = 2ms;
constexpr Duration kBetweenUpdates = 1s;
constexpr Duration kBetweenStorings = 10min;
constexpr Duration kCalm = 10s;  ///< without a change of the network
constexpr Duration kLatestStoring = 2h;
constexpr Duration kWordsHold = 1min;
constexpr std::size_t kMostWords = 256;
/// Bounds the mean places of a cell before cells are cut anew; they were about half as large when they were cut.
constexpr std::uint64_t kOutgrown = 192;

bool is_outgrown(const routing::Preparation& preparation) {
  return preparation.of.place_count() > kOutgrown * std::max<std::uint64_t>(1, preparation.base.size());
}

/// Joins method names by line breaks, which no method's name has.
std::string key_of(const std::set<std::string>& methods) {
  std::string key;
  for (const std::string& method : methods) key += (key.empty() ? "" : "\n") + method;
  return key;
}

}  // namespace

void Routes::want(const std::set<std::string>& methods) {
  if (methods.empty() || prepared_.contains(methods)) return;
  if (prepared_.size() == kMostSets) {
    ++context_.counters["routes: sets of methods that are not prepared"];
    return;
  }
  prepared_.try_emplace(methods);
}

bool Routes::is_prepared(const std::set<std::string>& methods) const {
  const auto found = prepared_.find(methods);
  return found != prepared_.end() && found->second.ready.has_value();
}

bool Routes::is_behind(const Prepared& prepared) const {
  return prepared.ready && prepared.ready->of.revision() != context_.snapshots.current().revision();
}

Result<Path> Routes::find(const PlaceId& from, const PlaceId& to, const std::set<std::string>& methods,
                          SteadyTime now) {
  const Snapshot& snapshot = context_.snapshots.current();
  const auto found = prepared_.find(methods);
  if (found == prepared_.end() || !found->second.ready) return shortest_path(snapshot, from, to, methods);
  Prepared& prepared = found->second;
  if (is_behind(prepared)) {
    prepared.ready = routing::update(*prepared.ready, snapshot);
    if (!prepared.is_anew) prepared.under_way.reset();
  }
  Result<std::optional<Path>> path = routing::find_path(*prepared.ready, snapshot, from, to, methods);
  if (!path) return fail(path.error());
  if (!*path) return fail(no_way(from, to, methods, now));
  return *std::move(*path);
}

const RuleMap& Routes::rules() {
  const Snapshot& snapshot = context_.snapshots.current();
  if (rules_of_ == snapshot.revision()) return rules_;
  rules_of_ = snapshot.revision();
  if (!snapshot.rules().empty() || !rules_.empty()) rules_ = RuleMap(snapshot);
  return rules_;
}

Result<Path> Routes::find_allowed(const PlaceId& from, const PlaceId& to, const std::set<std::string>& methods,
                                  bool keeps_limits, SteadyTime now, const ClosedHops* closed) {
  Result<Path> free = find(from, to, methods, now);
  const Passage passage{.begins = from, .keeps_limits = keeps_limits, .closed = closed};
  // Rules make ways longer and never shorter: the best of all is the best of those that are left, if it is one.
  if (!free || is_free(rules(), *free, passage)) return free;
  return shortest_path(context_.snapshots.current(), rules(), from, to, methods, passage);
}

Error Routes::no_way(const PlaceId& from, const PlaceId& to, const std::set<std::string>& methods, SteadyTime now) {
  const Snapshot& snapshot = context_.snapshots.current();
  const Key key{to, methods};
  const auto known = words_.find(key);
  const bool are_there = snapshot.place(from) != nullptr && snapshot.place(to) != nullptr;
  if (known != words_.end() && are_there && now - known->second.said_at < kWordsHold) {
    if (known->second.from == from) return known->second.error;
    return {ErrorCode::not_found, no_path_text(from, to, methods) + "; teach a connection"};
  }
  const Result<Path> path = shortest_path(snapshot, from, to, methods);
  // Only a preparation that is wrong gets here with a path: said, not driven.
  const Error error =
      path ? Error{ErrorCode::internal, "path: prepared routes miss a way that there is"} : path.error();
  if (!are_there) return error;
  if (words_.size() >= kMostWords) words_.clear();
  words_.insert_or_assign(key, Words{from, error, now});
  return error;
}

bool Routes::has_work(const Prepared& prepared) const {
  return !prepared.ready || prepared.under_way || is_behind(prepared);
}

std::optional<routing::Builder> Routes::from_store(const std::set<std::string>& methods) {
  const Result<Bytes> bytes = context_.store.preparation(key_of(methods));
  if (!bytes && bytes.error().code == ErrorCode::not_found) return std::nullopt;
  Result<routing::Builder> builder = bytes ? routing::Builder::to_resume(*bytes, context_.snapshots.current())
                                           : Result<routing::Builder>(fail(bytes.error()));
  if (builder) return *std::move(builder);
  ++context_.counters["routes: stored preparation is damaged, made anew"];
  return std::nullopt;
}

/// Returns the next work. What is stored is read once; a preparation that the network has outgrown is made anew
/// beside it.
routing::Builder Routes::next_work(const std::set<std::string>& methods, Prepared& prepared) {
  const Snapshot& snapshot = context_.snapshots.current();
  prepared.is_anew = !prepared.ready || is_outgrown(*prepared.ready);
  if (!std::exchange(prepared.is_store_read, true)) {
    if (std::optional<routing::Builder> stored = from_store(methods)) {
      prepared.stored = snapshot.revision();  // as good as
      return *std::move(stored);
    }
  }
  return prepared.is_anew ? routing::Builder::to_prepare(snapshot, methods)
                          : routing::Builder::to_update(*prepared.ready, snapshot);
}

void Routes::work(const std::set<std::string>& methods, Prepared& prepared, Now now) {
  if (!prepared.under_way) prepared.under_way = next_work(methods, prepared);
  prepared.next_piece = now.steady + kBetweenRoutePieces;
  if (prepared.under_way->step(kPiece)) return;
  routing::Preparation made = prepared.under_way->take();
  prepared.under_way.reset();
  if (made.methods != methods) {
    prepared.stored = {};  // under another name: made anew next
    return;
  }
  if (!prepared.ready) prepared.stored_at = now.steady;
  prepared.ready = std::move(made);
  prepared.next_piece = now.steady + kBetweenUpdates;
}

/// Returns when a preparation is to be stored: while nobody teaches, unless that is never, as writing that of a
/// million places takes a good part of a second.
std::optional<SteadyTime> Routes::storing_due(const Prepared& prepared) const {
  if (!prepared.ready || prepared.under_way || prepared.stored == prepared.ready->of.revision()) return std::nullopt;
  const bool is_first = prepared.stored == Revision{};
  const SteadyTime calm = std::max(seen_at_ + kCalm, prepared.stored_at + (is_first ? Duration{} : kBetweenStorings));
  return std::min(calm, prepared.stored_at + kLatestStoring);
}

std::optional<SteadyTime> Routes::due(const Prepared& prepared) const {
  const std::optional<SteadyTime> storing = storing_due(prepared);
  if (!has_work(prepared)) return storing;
  return storing ? std::min(*storing, prepared.next_piece) : prepared.next_piece;
}

void Routes::store(const std::set<std::string>& methods, Prepared& prepared, Now now) {
  prepared.stored_at = now.steady;
  prepared.stored = prepared.ready->of.revision();
  storage::Transaction transaction;
  transaction.changes.emplace_back(
      storage::PutPreparation{.methods = key_of(methods), .bytes = routing::encode(*prepared.ready)});
  // Kept or not: it is tried again when it is due again.
  std::ignore = context_.writer.commit(std::move(transaction), now);
}

void Routes::tick(Now now) {
  if (const Revision revision = context_.snapshots.current().revision(); seen_ != revision) {
    seen_ = revision;
    seen_at_ = now.steady;
  }
  for (auto& [methods, prepared] : prepared_) {
    const std::optional<SteadyTime> next = due(prepared);
    if (!next || *next > now.steady) continue;
    const std::optional<SteadyTime> storing = storing_due(prepared);
    if (storing && *storing <= now.steady) {
      store(methods, prepared, now);
    } else {
      work(methods, prepared, now);
    }
    return;
  }
}

std::optional<SteadyTime> Routes::next() const {
  std::optional<SteadyTime> next;
  for (const auto& [methods, prepared] : prepared_) {
    const std::optional<SteadyTime> at = due(prepared);
    if (at && (!next || *at < *next)) next = at;
  }
  return next;
}

}  // namespace weft::server
