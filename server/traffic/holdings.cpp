#include "server/traffic/holdings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::server {
namespace {

/// Sets the edge of a cell of the index: about what a robot's place takes up, with its uncertainty.
constexpr double kHoldingCell_m = 4.0;
/// Bounds the cells that one place is kept in; one that may lie anywhere is looked at by everybody of its part.
constexpr std::int64_t kMostCells = 64;

bool is_same(const Touched& a, const Touched& b) {
  return a.place == b.place && a.reach_m == b.reach_m;
}

std::int64_t cell(double metres) {
  return static_cast<std::int64_t>(std::floor(metres / kHoldingCell_m));
}

template <class Refs>
void drop(Refs& refs, const void* held) {
  const auto found = std::find_if(refs.begin(), refs.end(), [&](const auto& ref) { return ref.held == held; });
  if (found == refs.end()) return;
  *found = refs.back();
  refs.pop_back();
}

}  // namespace

Holdings::Refs& Holdings::ByPlace::at(const PlaceId& place) {
  std::vector<Refs>& row = rows_[place.experience];
  if (place.index >= row.size()) row.resize(place.index + 1);
  return row[place.index];
}

const Holdings::Refs* Holdings::ByPlace::find(const PlaceId& place) const {
  const auto row = rows_.find(place.experience);
  return row == rows_.end() || place.index >= row->second.size() ? nullptr : &row->second[place.index];
}

Holdings::Cells Holdings::cells_of(const Spot& spot, double reach_m) {
  const Eigen::AlignedBox2d box = box_of(spot, reach_m);
  Cells cells{.part = spot.part,
              .left = cell(box.min().x()),
              .right = cell(box.max().x()),
              .low = cell(box.min().y()),
              .high = cell(box.max().y())};
  cells.is_wide = (cells.right - cells.left + 1) * (cells.high - cells.low + 1) > kMostCells;
  return cells;
}

std::unique_ptr<Holdings::Held> Holdings::held_of(const TrafficMap& map, Proximity& proximity, const RobotId& robot,
                                                  const Touched& touched) const {
  auto held = std::make_unique<Held>();
  held->robot = robot;
  held->located = proximity.locate(map, touched);
  for (const Spot& spot : held->located.spots) held->cells.push_back(cells_of(spot, touched.reach_m));
  return held;
}

void Holdings::add(const Held& held) {
  held_at_.at(held.located.touched.place).push_back({&held, 0.0});
  for (const Near& near : *held.located.around) seen_from_.at(near.place).push_back({&held, near.clearance_m});
  for (const Cells& cells : held.cells) {
    if (cells.is_wide) {
      wide_[cells.part].push_back({&held});
      continue;
    }
    for (std::int64_t x = cells.left; x <= cells.right; ++x) {
      for (std::int64_t y = cells.low; y <= cells.high; ++y) in_cell_[{cells.part, x, y}].push_back({&held});
    }
  }
  if (!held.located.is_laid) ++unlaid_[held.robot];
}

void Holdings::take_out(const Held& held) {
  drop(held_at_.at(held.located.touched.place), &held);
  for (const Near& near : *held.located.around) drop(seen_from_.at(near.place), &held);
  for (const Cells& cells : held.cells) {
    if (cells.is_wide) {
      drop(wide_[cells.part], &held);
      continue;
    }
    for (std::int64_t x = cells.left; x <= cells.right; ++x) {
      for (std::int64_t y = cells.low; y <= cells.high; ++y) {
        const auto found = in_cell_.find({cells.part, x, y});
        drop(found->second, &held);
        if (found->second.empty()) in_cell_.erase(found);
      }
    }
  }
  if (!held.located.is_laid && --unlaid_[held.robot] == 0) unlaid_.erase(held.robot);
}

void Holdings::put(const TrafficMap& map, Proximity& proximity, const RobotId& robot,
                   const std::vector<Touched>& touched) {
  Robot& known = robots_[robot];
  const auto goes_on = [&] {
    const std::size_t common = std::min(known.size(), touched.size());
    return std::equal(touched.begin(), touched.begin() + static_cast<std::ptrdiff_t>(common), known.begin(),
                      [](const Touched& a, const auto& held) { return is_same(a, held->located.touched); });
  };
  // Mostly something was freed at the beginning, or added at the end.
  while (!known.empty() && !goes_on()) {
    take_out(*known.front());
    known.pop_front();
  }
  while (known.size() > touched.size()) {
    take_out(*known.back());
    known.pop_back();
  }
  for (std::size_t i = known.size(); i < touched.size(); ++i) {
    known.push_back(held_of(map, proximity, robot, touched[i]));
    add(*known.back());
  }
  if (known.empty()) robots_.erase(robot);
}

/// Visits what may be near by what was measured around either place, with how near; the same may come twice.
template <class Meet>
void Holdings::for_each_around(const LocatedPlace& here, Meet&& meet) const {
  const PlaceId& place = here.touched.place;
  if (const Refs* const refs = held_at_.find(place)) {
    for (const Ref& ref : *refs) meet(*ref.held, 0.0);
  }
  for (const Near& near : *here.around) {
    const Refs* const refs = held_at_.find(near.place);
    if (refs == nullptr) continue;
    for (const Ref& ref : *refs) meet(*ref.held, near.clearance_m);
  }
  if (const Refs* const refs = seen_from_.find(place)) {
    for (const Ref& ref : *refs) meet(*ref.held, ref.clearance_m);
  }
}

/// Visits what may be near by the layout; the same may come several times.
template <class Meet>
void Holdings::for_each_in_cells(const LocatedPlace& here, Meet&& meet) const {
  const auto visit = [&](const Refs& refs) {
    for (const Ref& ref : refs) meet(*ref.held);
  };
  for (const Spot& spot : here.spots) {
    const Cells cells = cells_of(spot, here.touched.reach_m + kMargin_m);
    if (const auto wide = wide_.find(spot.part); wide != wide_.end()) visit(wide->second);
    if (cells.is_wide) {
      for (auto at = in_cell_.lower_bound({spot.part, std::numeric_limits<std::int64_t>::min(), 0});
           at != in_cell_.end() && std::get<0>(at->first) == spot.part; ++at) {
        visit(at->second);
      }
      continue;
    }
    for (std::int64_t x = cells.left; x <= cells.right; ++x) {
      for (std::int64_t y = cells.low; y <= cells.high; ++y) {
        const auto found = in_cell_.find({spot.part, x, y});
        if (found != in_cell_.end()) visit(found->second);
      }
    }
  }
}

std::set<RobotId> Holdings::near(const TrafficMap& map, Proximity& proximity, const LocatedPlace& here,
                                 const RobotId& except) const {
  std::set<RobotId> robots;
  for_each_around(here, [&](const Held& held, double clearance_m) {
    if (held.robot != except && clearance_m <= room_m(here, held.located)) robots.insert(held.robot);
  });
  for_each_in_cells(here, [&](const Held& held) {
    if (held.robot == except || robots.contains(held.robot)) return;
    if (proximity.are_near_by_layout(map, here, held.located)) robots.insert(held.robot);
  });
  return robots;
}

bool Holdings::holds_near(const TrafficMap& map, Proximity& proximity, const RobotId& robot,
                          const LocatedPlace& here) const {
  const auto known = robots_.find(robot);
  return known != robots_.end() && std::any_of(known->second.begin(), known->second.end(), [&](const auto& held) {
           return proximity.overlap(map, here, held->located);
         });
}

std::optional<double> Holdings::clearance_m(const Proximity& proximity, const RobotId& robot,
                                            const LocatedPlace& here) const {
  std::optional<double> least_m;
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return least_m;
  for (const auto& held : known->second) {
    const std::optional<double> one_m = proximity.clearance_m(here, held->located);
    if (one_m) least_m = std::min(least_m.value_or(*one_m), *one_m);
  }
  return least_m;
}

std::optional<double> Holdings::distance_m(const RobotId& robot, const LocatedPlace& here) const {
  std::optional<double> least_m;
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return least_m;
  for (const auto& held : known->second) {
    for (const Spot& of_held : held->located.spots) {
      for (const Spot& of_here : here.spots) {
        if (of_held.part != of_here.part) continue;
        const double one_m = Layout::distance_m(of_held, of_here);
        least_m = std::min(least_m.value_or(one_m), one_m);
      }
    }
  }
  return least_m;
}

bool Holdings::are_others_laid(const RobotId& robot) const {
  return unlaid_.empty() || (unlaid_.size() == 1 && unlaid_.begin()->first == robot);
}

void Holdings::renew(const TrafficMap& map, Proximity& proximity, Held& held) {
  take_out(held);
  held = std::move(*held_of(map, proximity, held.robot, held.located.touched));
  add(held);
}

void Holdings::refresh(const TrafficMap& map, Proximity& proximity, const std::vector<PlaceId>& places) {
  for (const PlaceId& place : places) {
    const Refs* const refs = held_at_.find(place);
    if (refs == nullptr || refs->empty()) continue;
    std::set<RobotId> holders;
    for (const Ref& ref : *refs) holders.insert(ref.held->robot);
    for (const RobotId& robot : holders) {
      for (const auto& held : robots_.at(robot)) {
        if (held->located.touched.place == place) renew(map, proximity, *held);
      }
    }
  }
}

void Holdings::refresh_unlaid(const TrafficMap& map, Proximity& proximity) {
  const std::map<RobotId, std::size_t> unlaid = unlaid_;
  for (const auto& [robot, count] : unlaid) {
    for (const auto& held : robots_.at(robot)) {
      if (!held->located.is_laid) renew(map, proximity, *held);
    }
  }
}

void Holdings::refresh_all(const TrafficMap& map, Proximity& proximity) {
  held_at_.clear();
  seen_from_.clear();
  in_cell_.clear();
  wide_.clear();
  unlaid_.clear();
  for (const auto& [robot, all] : robots_) {
    for (const auto& held : all) {
      *held = std::move(*held_of(map, proximity, robot, held->located.touched));
      add(*held);
    }
  }
}

}  // namespace weft::server
