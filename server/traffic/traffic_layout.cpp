#include <algorithm>
#include <chrono>
#include <utility>

#include "server/traffic/traffic.hpp"

/// Has the map laid out for traffic, and says what is known from that of the whole fleet.
namespace weft::server {
namespace {
using namespace std::chrono_literals;

/// Bounds what is laid out at once, at the start and after an edit: nobody has to wait for a small map.
constexpr std::size_t kPlacesAtOnce = 2000;
/// Bounds a piece of work between two messages: about 1 ms on a large map.
constexpr std::size_t kPlacesOfPiece = 250;
constexpr Duration kBetweenLayoutPieces = 2ms;
/// Bounds the places that are laid out without a note (more take longer than a moment), then: the notes on the way.
constexpr std::uint64_t kWorthTelling = 20'000;
constexpr std::uint64_t kTimesTold = 5;

}  // namespace

void Traffic::lay_out_at_once() {
  proximity_.layout().work(kPlacesAtOnce);
  map_changed();
}

/// Looks up again what is held, as far as the map or its layout says something else of it now, and wakes everybody.
void Traffic::map_changed() {
  if (std::exchange(laid_moves_, proximity_.layout().moves()) != laid_moves_) {
    holdings_.refresh_all(map(), proximity_);
  } else {
    holdings_.refresh_unlaid(map(), proximity_);
  }
  watches_.wake_all();
  ++parts_version_;
}

void Traffic::edited(const Snapshot& before) {
  if (holds_what_is_out()) history_.push_back(std::make_shared<const Snapshot>(before));
  proximity_.edited(context_.snapshots.shared_current(), before);
  holdings_.refresh_all(map(), proximity_);
  lay_out_at_once();
}

void Traffic::joined(const Batch& batch) {
  const std::vector<PlaceId> looks_different = proximity_.joined(context_.snapshots.shared_current(), batch);
  proximity_.layout().work(kPlacesOfPiece);
  holdings_.refresh(map(), proximity_, looks_different);
  map_changed();
}

void Traffic::tick(Now now) {
  if (!proximity_.layout().has_work()) return;
  if (next_piece_ > now.steady) return;
  next_piece_ = now.steady + kBetweenLayoutPieces;
  tell_of_layout(now);
  if (proximity_.layout().work(kPlacesOfPiece)) map_changed();
  tell_of_layout(now);
}

std::optional<SteadyTime> Traffic::next() const {
  if (!proximity_.layout().has_work()) return std::nullopt;
  return next_piece_;
}

void Traffic::tell_of_layout(Now now) {
  const std::uint64_t total = context_.snapshots.current().place_count();
  const std::uint64_t laid = proximity_.layout().laid() + proximity_.layout().under_way();
  const bool is_done = !proximity_.layout().has_work();
  const std::uint64_t left = total - std::min(total, laid);
  if (!is_layout_announced_ && left < kWorthTelling) return;
  const bool is_farther = laid >= laid_told_ + total / kTimesTold;
  if (is_layout_announced_ && !is_done && !is_farther) return;
  is_layout_announced_ = !is_done;
  laid_told_ = laid;
  const std::string places =
      std::to_string(laid) + " of " + std::to_string(total) + " places of the map are laid out";
  context_.writer.note({.at = {},
                        .kind = is_done ? "traffic.laid_out" : "traffic.laying_out",
                        .robot = {},
                        .goal = {},
                        .cause = places + (is_done ? "" : "; no robot is released over a part before all of it is"),
                        .who = "server"},
                       now);
}

std::vector<std::vector<RobotId>> Traffic::by_part() {
  std::map<std::uint32_t, std::vector<RobotId>> robots;
  for (const auto& [robot, holder] : holders_) {
    const storage::PutOccupancy& held = holder.occupancy;
    if (held.held.places.empty()) continue;
    const std::optional<std::uint32_t> part = proximity_.part_of(map(), held.held.places[held.from]);
    if (part) robots[*part].push_back(robot);
  }
  std::vector<std::vector<RobotId>> parts;
  for (auto& [part, of_part] : robots) parts.push_back(std::move(of_part));
  std::sort(parts.begin(), parts.end());
  return parts;
}

}  // namespace weft::server
