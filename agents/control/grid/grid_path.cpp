#include "agents/control/grid/grid_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>

namespace weft::agents {
namespace {

constexpr auto kNobody = std::numeric_limits<std::uint32_t>::max();

struct Neighbour {
  int columns, rows;
  float length;  ///< cells
};
constexpr float kDiagonal = std::numbers::sqrt2_v<float>;
constexpr std::array<Neighbour, 8> kNeighbours = {{{1, 0, 1.0F},
                                                   {-1, 0, 1.0F},
                                                   {0, 1, 1.0F},
                                                   {0, -1, 1.0F},
                                                   {1, 1, kDiagonal},
                                                   {1, -1, kDiagonal},
                                                   {-1, 1, kDiagonal},
                                                   {-1, -1, kDiagonal}}};

float octile(const Cell& a, const Cell& b) {
  const auto columns = static_cast<float>(std::abs(a.column - b.column));
  const auto rows = static_cast<float>(std::abs(a.row - b.row));
  return std::max(columns, rows) + (kDiagonal - 1.0F) * std::min(columns, rows);
}

struct Open {
  float total;  ///< from the start over this cell to the goal, at least
  std::uint32_t cell;
  bool operator<(const Open& other) const {
    return total != other.total ? total > other.total : cell > other.cell;  // the least first
  }
};

/// Searches one raster.
class Search {
 public:
  Search(const GridPathConfig& config, const RoomToDrive& room)
      : config_(config),
        room_(room),
        raster_(room.clearance().raster),
        cost_(raster_.size(), std::numeric_limits<float>::infinity()),
        before_(raster_.size(), kNobody) {}

  bool find(const Cell& from, const Cell& to) {
    cost_[raster_.index(from)] = 0.0F;
    open_.push({octile(from, to), number_of(from)});
    while (!open_.empty()) {
      const Open next = open_.top();
      open_.pop();
      const Cell cell = cell_of(next.cell);
      if (cell == to) return true;
      if (next.total > cost_[next.cell] + octile(cell, to) + kSlack) continue;  // reached more cheaply since
      expand(cell, to);
    }
    return false;
  }

  std::vector<Eigen::Vector2d> way_to(const Cell& to) const {
    std::vector<Eigen::Vector2d> way;
    for (std::uint32_t at = number_of(to); at != kNobody; at = before_[at])
      way.push_back(raster_.centre(cell_of(at)));
    std::reverse(way.begin(), way.end());
    return way;
  }

 private:
  static constexpr float kSlack = 1e-3F;

  std::uint32_t number_of(const Cell& cell) const { return static_cast<std::uint32_t>(raster_.index(cell)); }
  Cell cell_of(std::uint32_t number) const {
    return {static_cast<int>(number) % raster_.columns, static_cast<int>(number) / raster_.columns};
  }
  /// Returns what a step into a cell costs for each cell of its length.
  float dearness(double clearance_m) const {
    const double spare = clearance_m - room_.radius_m();
    if (config_.comfort_m <= 0.0 || spare >= config_.comfort_m) return 1.0F;
    return static_cast<float>(1.0 + config_.cost_of_narrow * (1.0 - std::max(spare, 0.0) / config_.comfort_m));
  }
  void expand(const Cell& cell, const Cell& to) {
    const float so_far = cost_[raster_.index(cell)];
    for (const Neighbour& step : kNeighbours) {
      const Cell next{cell.column + step.columns, cell.row + step.rows};
      if (!raster_.holds(next)) continue;
      const std::size_t index = raster_.index(next);
      const auto clearance_m = static_cast<double>(room_.clearance().metres[index]);
      if (!room_.allows(raster_.centre(next), clearance_m)) continue;
      const float cost = so_far + step.length * dearness(clearance_m);
      if (cost >= cost_[index]) continue;
      cost_[index] = cost;
      before_[index] = number_of(cell);
      open_.push({cost + octile(next, to), number_of(next)});
    }
  }

  const GridPathConfig& config_;
  const RoomToDrive& room_;
  Raster raster_;
  std::vector<float> cost_;
  std::vector<std::uint32_t> before_;
  std::priority_queue<Open> open_;
};

/// Returns the nearest cell around a point that the robot may be in.
std::optional<Cell> room_near(const RoomToDrive& room, const Eigen::Vector2d& point, double within_m) {
  const Raster& raster = room.clearance().raster;
  const Cell middle = raster.cell_at(point);
  const int reach = static_cast<int>(std::ceil(within_m / raster.cell_m));
  std::optional<Cell> nearest;
  double nearest_m = within_m + raster.cell_m;
  for (int row = middle.row - reach; row <= middle.row + reach; ++row) {
    for (int column = middle.column - reach; column <= middle.column + reach; ++column) {
      const Cell cell{column, row};
      const Eigen::Vector2d centre = raster.centre(cell);
      const double away_m = (centre - point).norm();
      if (away_m >= nearest_m || !raster.holds(cell) || !room.allows(centre)) continue;
      nearest = cell;
      nearest_m = away_m;
    }
  }
  return nearest;
}

}  // namespace

std::optional<std::vector<Eigen::Vector2d>> find_path(const GridPathConfig& config, const RoomToDrive& room,
                                                      const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Cell start = room.clearance().raster.cell_at(from);
  if (!room.clearance().raster.holds(start)) return std::nullopt;
  const std::optional<Cell> goal = room_near(room, to, config.goal_within_m);
  if (!goal) return std::nullopt;
  Search search(config, room);
  if (!search.find(start, *goal)) return std::nullopt;
  return search.way_to(*goal);
}

}  // namespace weft::agents
