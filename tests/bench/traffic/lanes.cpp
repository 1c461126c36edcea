#include "tests/bench/traffic/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <istream>
#include <numbers>
#include <sstream>
#include <string_view>

namespace weft::bench {
namespace {

constexpr std::uint32_t kLargest = 100'000;
constexpr std::uint32_t kDeadEnd = 8;  // cells
/// Is what robots drive over: floor, as movingai writes it, and before shelves and at stations, as LoRR does.
constexpr std::string_view kFree = ".GSE";

Error wrong(const std::string& what) {
  return {ErrorCode::invalid, "no movingai map: " + what};
}

std::vector<bool> reached(const std::vector<std::vector<Cell>>& next, Cell from) {
  std::vector<bool> seen(next.size());
  std::deque<Cell> open = {from};
  seen[from] = true;
  while (!open.empty()) {
    const Cell here = open.front();
    open.pop_front();
    for (const Cell there : next[here]) {
      if (seen[there]) continue;
      seen[there] = true;
      open.push_back(there);
    }
  }
  return seen;
}

std::vector<std::vector<Cell>> turned_round(const std::vector<std::vector<Cell>>& next) {
  std::vector<std::vector<Cell>> before(next.size());
  for (Cell cell = 0; cell < next.size(); ++cell) {
    for (const Cell there : next[cell]) before[there].push_back(cell);
  }
  return before;
}

/// Keeps the largest set of cells of which each can be reached from each.
Network strong_part(const std::vector<Eigen::Vector2d>& at, const std::vector<std::vector<Cell>>& next) {
  const std::vector<std::vector<Cell>> before = turned_round(next);
  std::vector<std::uint32_t> part(at.size(), 0);
  std::uint32_t parts = 0;
  std::uint32_t largest = 0;
  std::size_t most = 0;
  for (Cell cell = 0; cell < at.size(); ++cell) {
    if (part[cell] != 0) continue;
    ++parts;
    const std::vector<bool> there = reached(next, cell);
    const std::vector<bool> back = reached(before, cell);
    std::size_t count = 0;
    for (Cell other = 0; other < at.size(); ++other) {
      if (!there[other] || !back[other]) continue;
      part[other] = parts;
      ++count;
    }
    if (count <= most) continue;
    most = count;
    largest = parts;
  }
  Network network;
  std::vector<Cell> number(at.size(), kNoCell);
  for (Cell cell = 0; cell < at.size(); ++cell) {
    if (part[cell] != largest) continue;
    number[cell] = static_cast<Cell>(network.at.size());
    network.at.push_back(at[cell]);
  }
  network.next.resize(network.at.size());
  for (Cell cell = 0; cell < at.size(); ++cell) {
    if (number[cell] == kNoCell) continue;
    for (const Cell there : next[cell]) {
      if (number[there] != kNoCell) network.next[number[cell]].push_back(number[there]);
    }
  }
  network.before = turned_round(network.next);
  return network;
}

}  // namespace

bool Network::leads(Cell from, Cell to) const {
  return std::find(next[from].begin(), next[from].end(), to) != next[from].end();
}

Result<Grid> read_grid(std::istream& text) {
  std::string word;
  std::string type;
  Grid grid;
  if (!(text >> word >> type) || word != "type" || type != "octile")
    return fail(wrong("it begins with: type octile"));
  for (int i = 0; i < 2; ++i) {
    std::uint32_t value = 0;
    if (!(text >> word >> value) || value == 0 || value > kLargest) {
      return fail(wrong("height and width are from 1 to " + std::to_string(kLargest)));
    }
    (word == "height" ? grid.height : grid.width) = value;
  }
  if (!(text >> word) || word != "map" || grid.height == 0 || grid.width == 0) {
    return fail(wrong("before its rows stand height, width and map"));
  }
  grid.is_free.reserve(std::size_t{grid.width} * grid.height);
  for (std::uint32_t y = 0; y < grid.height; ++y) {
    if (!(text >> word) || word.size() != grid.width) {
      return fail(wrong("row " + std::to_string(y) + " has not " + std::to_string(grid.width) + " squares"));
    }
    for (const char square : word) grid.is_free.push_back(kFree.find(square) != std::string_view::npos);
  }
  return grid;
}

Grid warehouse(std::uint32_t columns, std::uint32_t rows) {
  constexpr std::uint32_t end = 6;  // squares of room at either end
  Grid grid;
  grid.width = 2 * end + columns * 11 - 1;
  grid.height = rows * 3 + 1;
  for (std::uint32_t y = 0; y < grid.height; ++y) {
    for (std::uint32_t x = 0; x < grid.width; ++x) {
      const bool is_beside = x < end || x + end >= grid.width;
      grid.is_free.push_back(is_beside || y % 3 == 0 || (x - end) % 11 == 10);
    }
  }
  return grid;
}

Network network_of(const Grid& grid, Lanes lanes) {
  std::vector<Eigen::Vector2d> at(grid.is_free.size());
  std::vector<std::vector<Cell>> next(grid.is_free.size());
  for (std::uint32_t y = 0; y < grid.height; ++y) {
    for (std::uint32_t x = 0; x < grid.width; ++x) {
      const Cell here = y * grid.width + x;
      at[here] = {kCell_m * x, -kCell_m * y};
      if (!grid.is_free[here]) continue;
      const bool is_two_way = lanes == Lanes::two_way;
      const bool goes_right = y / 3 % 2 == 0;
      const bool goes_down = x / 11 % 2 == 0;
      const auto lead = [&](bool leads, std::int64_t to_x, std::int64_t to_y) {
        if (!leads || to_x < 0 || to_y < 0 || to_x >= grid.width || to_y >= grid.height) return;
        const auto there = static_cast<Cell>(to_y * grid.width + to_x);
        if (grid.is_free[there]) next[here].push_back(there);
      };
      const std::int64_t column = x;
      const std::int64_t row = y;
      lead(is_two_way || goes_right, column + 1, row);
      lead(is_two_way || !goes_right, column - 1, row);
      lead(is_two_way || goes_down, column, row + 1);
      lead(is_two_way || !goes_down, column, row - 1);
    }
  }
  return strong_part(at, next);
}

Network ring(std::uint32_t cells, std::uint32_t dead_ends) {
  std::vector<Eigen::Vector2d> at;
  std::vector<std::vector<Cell>> next(cells);
  const double radius_m = kCell_m * cells / (2.0 * std::numbers::pi);
  const auto spoke = [&](std::uint32_t cell, double at_m) {
    const double angle = 2.0 * std::numbers::pi * cell / cells;
    return Eigen::Vector2d(at_m * std::cos(angle), at_m * std::sin(angle));
  };
  for (std::uint32_t i = 0; i < cells; ++i) {
    at.push_back(spoke(i, radius_m));
    next[i].push_back((i + 1) % cells);
  }
  for (std::uint32_t i = 0; i < dead_ends; ++i) {
    const std::uint32_t mouth = i * cells / dead_ends;
    Cell before = mouth;
    for (std::uint32_t deep = 1; deep <= kDeadEnd; ++deep) {
      const auto here = static_cast<Cell>(at.size());
      at.push_back(spoke(mouth, radius_m + kCell_m * deep));
      next.push_back({before});
      next[before].push_back(here);
      before = here;
    }
  }
  return strong_part(at, next);
}

std::vector<std::uint32_t> steps_to(const Network& network, Cell to) {
  std::vector<std::uint32_t> steps(network.size(), kNoCell);
  std::deque<Cell> open = {to};
  steps[to] = 0;
  while (!open.empty()) {
    const Cell here = open.front();
    open.pop_front();
    for (const Cell there : network.before[here]) {
      if (steps[there] != kNoCell) continue;
      steps[there] = steps[here] + 1;
      open.push_back(there);
    }
  }
  return steps;
}

}  // namespace weft::bench
