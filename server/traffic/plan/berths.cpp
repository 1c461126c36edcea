#include "server/traffic/plan/berths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/traffic/plan/drives.hpp"

namespace weft::server {
namespace {

constexpr double kBerthCell_m = 4.0;
constexpr double kLongestSlack_m = 5.0;
/// Bounds how far is searched for berths, from below: they come each room along a run that does not turn back.
constexpr double kFarthest_m = 6.0;
/// Is what locating a place counts as work, and how many comparisons with others count as one.
constexpr std::uint64_t kWorkToLocate = 4;
constexpr std::size_t kComparedForWork = 16;
/// Bounds how many ways of driving are numbered until all are forgotten: what is closed to one robot makes another.
constexpr std::size_t kMostDrives = 64;

}  // namespace

bool Berths::follow(const RuledNetwork& network, double footprint_m) {
  if (!begin_to_follow(network, footprint_m)) return false;
  return cut(std::numeric_limits<std::size_t>::max());
}

bool Berths::begin_to_follow(const RuledNetwork& network, double footprint_m) {
  see(network.network);
  rules_ = network.rules;
  const bool is_same = network_ != nullptr && network_ == network.network && footprint_m_ == footprint_m &&
                       laid_moves_ == proximity_.layout().moves() && laid_ == proximity_.layout().laid();
  if (is_same && methods_.size() <= kMostDrives) return false;
  if (footprint_m_ != footprint_m) runs_.clear();
  network_ = network.network;
  footprint_m_ = footprint_m;
  laid_moves_ = proximity_.layout().moves();
  laid_ = proximity_.layout().laid();
  in_cell_.clear();
  middle_in_cell_.clear();
  middles_.clear();
  numbers_.clear();
  berths_.clear();
  if (methods_.size() > kMostDrives) methods_.clear();
  located_.clear();
  cut_through_.reset();
  std::erase_if(runs_, [this](const auto& run) { return network_->experience(run.first) == nullptr; });
  return true;
}

std::uint32_t Berths::methods(const Drives& drives) {
  const auto number =
      static_cast<std::uint32_t>(std::find(methods_.begin(), methods_.end(), drives) - methods_.begin());
  if (number == methods_.size()) methods_.push_back(drives);
  return number;
}

CutRules Berths::cut_rules() {
  const double room_m = this->room_m();
  const Layout& layout = proximity_.layout();
  return {.room_m = room_m,
          .are_clear =
              [this, room_m, &layout](const PlaceId& a, const PlaceId& b) {
                const std::optional<Spot> first = layout.spot(a);
                const std::optional<Spot> second = layout.spot(b);
                if (!first || !second || first->part != second->part) return true;
                // Asks what lies around where the whole layout does not tell them apart.
                return !layout.are_near(*first, *second, room_m) ||
                       !proximity_.overlap(TrafficMap(*latest_), locate(a), locate(b));
              },
          .is_taken = [this](const PlaceId& place) { return is_taken(place); }};
}

bool Berths::cut(std::size_t places) {
  const auto& runs = network_->experiences();
  auto next = cut_through_ ? runs.upper_bound(*cut_through_) : runs.begin();
  for (std::size_t done = 0; next != runs.end() && done < places; ++next) {
    done += cut_run(next->first, next->second);
    cut_through_ = next->first;
  }
  return next == runs.end();
}

/// Cuts the run if it is not as it was. Returns how many of its places were looked at.
std::size_t Berths::cut_run(const ExperienceId& id, const std::shared_ptr<const Experience>& experience) {
  Run& run = runs_[id];
  const bool is_known = run.of == experience && run.is_laid;
  if (!is_known) {
    run.of = experience;
    run.is_laid = !experience->places.empty() && proximity_.layout().spot(experience->places.begin()->id).has_value();
    run.cuts = cuts_of(*experience, cut_rules());
  }
  for (const std::uint32_t index : run.cuts) put_in_cell({id, index}, in_cell_);
  return std::max<std::size_t>(1, is_known ? run.cuts.size() : experience->places.size());
}

bool Berths::is_taken(const PlaceId& place) {
  bool taken = false;
  const LocatedPlace here = locate(place);
  for_each_near(here, in_cell_, [&](const PlaceId& other) {
    taken = taken ||
            (other.experience < place.experience && proximity_.overlap(TrafficMap(*latest_), here, locate(other)));
  });
  return taken;
}

bool Berths::is_cut(const PlaceId& place) const {
  const auto run = runs_.find(place.experience);
  return run != runs_.end() && std::binary_search(run->second.cuts.begin(), run->second.cuts.end(), place.index);
}

/// Returns as `touched_by` does, for a route that comes by there on its own run.
double Berths::reach_m(const PlaceId& place) const {
  const Experience* const run = network_->experience(place.experience);
  double slack_m = kLeastSlack_m;
  const auto widen = [&](const Edge* hop) {
    if (hop != nullptr) slack_m = std::max(slack_m, std::min(distance_m(hop->a_from_b) / 2.0, kLongestSlack_m));
  };
  widen(place.index > 0 ? run->hop(place.index - 1) : nullptr);
  widen(run->hop(place.index));
  return footprint_m_ + slack_m;
}

LocatedPlace Berths::locate(const PlaceId& place) {
  const auto known = located_.find(place);
  if (known != located_.end()) return known->second;
  looked_up_ += kWorkToLocate;
  const Touched touched{.place = place, .reach_m = reach_m(place)};
  return located_.emplace(place, proximity_.locate(TrafficMap(*latest_), touched)).first->second;
}

void Berths::put_in_cell(const PlaceId& place, Cells& cells) {
  const std::optional<Spot> spot = proximity_.layout().spot(place);
  if (!spot) return;
  const Eigen::Vector2d at = spot->part_from_place.translation() / kBerthCell_m;
  cells[{spot->part, std::llround(at.x()), std::llround(at.y())}].push_back(place);
}

template <class Visit>
void Berths::for_each_near(const LocatedPlace& here, const Cells& cells, Visit&& visit) {
  for (const Spot& spot : here.spots) {
    const Eigen::Vector2d at = spot.part_from_place.translation() / kBerthCell_m;
    const std::int64_t x = std::llround(at.x());
    const std::int64_t y = std::llround(at.y());
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const auto cell = cells.find({spot.part, x + dx, y + dy});
        if (cell == cells.end()) continue;
        for (const PlaceId& place : cell->second) visit(place);
      }
    }
  }
}

Berth Berths::number(const PlaceId& place, bool is_cut) {
  const auto [entry, is_new] = numbers_.try_emplace(place, static_cast<Berth>(berths_.size()));
  if (is_new) berths_.push_back({.located = locate(place), .is_cut = is_cut, .beside = {}, .arcs = {}});
  return entry->second;
}

/// Numbers the middle of a drive; one that is a berth, or of another drive as well, has that number.
Berth Berths::middle(const PlaceId& place) {
  const auto known = numbers_.find(place);
  if (known != numbers_.end()) return known->second;
  const auto [entry, is_new] = middles_.try_emplace(place, static_cast<Berth>(berths_.size()));
  if (is_new) {
    berths_.push_back({.located = locate(place), .is_cut = false, .beside = {}, .arcs = {}});
    put_in_cell(place, middle_in_cell_);
  }
  return entry->second;
}

Berth Berths::at(const PlaceId& place) {
  const auto known = numbers_.find(place);
  if (known != numbers_.end()) return known->second;
  if (is_cut(place)) return number(place, true);
  const Berth guest = number(place, false);
  put_in_cell(place, in_cell_);
  forget_around(guest);
  return guest;
}

/// Forgets what begins or ends near a new berth, and does not know of it.
void Berths::forget_around(Berth berth) {
  std::vector<PlaceId> near;
  for_each_near(berths_[berth].located, in_cell_, [&](const PlaceId& place) { near.push_back(place); });
  for (const PlaceId& place : near) {
    const auto known = numbers_.find(place);
    if (known == numbers_.end()) continue;
    berths_[known->second].beside.reset();
    berths_[known->second].arcs.clear();
  }
}

void Berths::add_touched(const LocatedPlace& here, std::set<Berth>& touched) {
  std::vector<PlaceId> near;
  for_each_near(here, in_cell_, [&](const PlaceId& place) { near.push_back(place); });
  looked_up_ += 1 + near.size() / kComparedForWork;
  for (const PlaceId& place : near) {
    if (proximity_.overlap(TrafficMap(*latest_), here, locate(place))) touched.insert(number(place, is_cut(place)));
  }
}

const std::vector<Berth>& Berths::beside(Berth berth) {
  Known& known = berths_[berth];
  if (!known.beside) {
    std::set<Berth> touched;
    add_touched(known.located, touched);
    touched.erase(berth);
    known.beside.emplace(touched.begin(), touched.end());
  }
  return *known.beside;
}

Berths::Arcs& Berths::arcs(Berth berth, std::uint32_t methods) {
  std::deque<Arcs>& all = berths_[berth].arcs;
  if (methods >= all.size()) all.resize(methods + std::size_t{1});
  return all[methods];
}

const std::vector<PlaceId>& Berths::way(Berth from, const BerthArc& arc, std::uint32_t methods) const {
  const Arcs& known = berths_[from].arcs[methods];
  return known.ways[static_cast<std::size_t>(&arc - known.next.data())];
}

/// Returns what can be driven by who stands at that berth.
Drivables Berths::ruled(Berth berth, std::uint32_t methods) const {
  return {.network = *network_,
          .rules = *rules_,
          .methods = methods_[methods].methods,
          .passage = {.begins = place(berth),
                      .keeps_limits = methods_[methods].keeps_limits,
                      .closed = &methods_[methods].closed},
          .farthest_m = std::max(kFarthest_m, (kMostRooms + 1.0) * room_m())};
}

/// Returns whether who stands at the berth stands at that cut, too: no drive ends there.
bool Berths::is_beside(Berth berth, const PlaceId& cut) {
  const std::vector<Berth>& all = beside(berth);
  return std::binary_search(all.begin(), all.end(), number(cut, true));
}

const std::vector<BerthArc>& Berths::next(Berth from, std::uint32_t methods) {
  Arcs& known = arcs(from, methods);
  if (std::exchange(known.has_next, true)) return known.next;
  const auto stops = [this, from](const PlaceId& place) {
    if (is_cut(place)) return is_beside(from, place) ? Stop::on_the_way : Stop::end;
    return numbers_.contains(place) ? Stop::on_the_way : Stop::none;
  };
  for (Drive& drive : drives(ruled(from, methods), place(from), Heading::onward, stops)) {
    std::set<Berth> touched;
    for (const PlaceId& place : drive.places) {
      const LocatedPlace here = locate(place);
      add_touched(here, touched);
      for_each_near(here, middle_in_cell_, [&](const PlaceId& other) {
        if (proximity_.overlap(TrafficMap(*latest_), here, locate(other))) touched.insert(middles_.at(other));
      });
    }
    // Leaves out where it sets off: it stands there already, and nobody beside it.
    touched.erase(from);
    for (const Berth berth : beside(from)) touched.erase(berth);
    const Berth to = number(drive.to, is_cut(drive.to));
    touched.insert(to);
    touched.insert(beside(to).begin(), beside(to).end());
    if (to != from) touched.erase(from);
    known.next.push_back({.to = to,
                          .length_m = drive.length_m,
                          .middle = middle(drive.places[(drive.places.size() - 1) / 2]),
                          .touches = {touched.begin(), touched.end()}});
    known.ways.push_back(std::move(drive.places));
  }
  return known.next;
}

const std::vector<BerthGraph::Before>& Berths::before(Berth to, std::uint32_t methods) {
  Arcs& known = arcs(to, methods);
  if (std::exchange(known.has_before, true)) return known.before;
  const auto stops = [this, to](const PlaceId& place) {
    if (!is_cut(place)) return Stop::none;
    return is_beside(to, place) ? Stop::on_the_way : Stop::end;
  };
  for (const Drive& drive : drives(ruled(to, methods), place(to), Heading::backward, stops)) {
    known.before.push_back({number(drive.to, true), drive.length_m});
  }
  return known.before;
}

}  // namespace weft::server
