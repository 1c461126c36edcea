#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"

namespace weft::server::test {

enum class Heading : std::uint8_t { east, south, west, north };

/// Holds squares, as drawn: a row of text each, '.' one robot's room, '+' a crossing. Robots drive on ahead or turn
/// into a side street; nobody turns round or drives backwards. A berth is a square with the heading of who stands
/// there, on a crossing with the one that it came with and the one with which it leaves; one robot stands on a
/// square.
class HeadedGraph final : public BerthGraph {
 public:
  explicit HeadedGraph(const std::vector<std::string>& rows) {
    for (int y = 0; y < static_cast<int>(rows.size()); ++y) {
      for (int x = 0; x < static_cast<int>(rows[y].size()); ++x) {
        if (rows[y][x] == '.') add(x, y, kSides);
        if (rows[y][x] == '+') add(x, y, kSides * kSides);
      }
    }
    next_.resize(numbers_.size());
    before_.resize(numbers_.size());
    beside_.resize(numbers_.size());
    middles_ = static_cast<Berth>(numbers_.size());
    for (const auto& [here, from] : numbers_) lie_beside(here, from);
    for (const auto& [here, from] : numbers_) join(here, from);
  }

  Berth at(int x, int y, Heading heading) const { return numbers_.at({x, y, static_cast<std::uint8_t>(heading)}); }

  const std::vector<BerthArc>& next(Berth from, std::uint32_t /*methods*/) override { return next_[from]; }
  const std::vector<Before>& before(Berth to, std::uint32_t /*methods*/) override { return before_[to]; }
  const std::vector<Berth>& beside(Berth berth) override { return beside_[berth]; }
  bool is_cut(Berth berth) const override { return berth < next_.size(); }
  std::size_t size() const override { return middles_; }

 private:
  /// Is where a square lies, and the heading there; on a crossing, times kSides, and the one with which it is left.
  using Square = std::tuple<int, int, std::uint8_t>;
  static constexpr std::uint8_t kSides = 4;

  void add(int x, int y, std::uint8_t headings) {
    for (std::uint8_t heading = 0; heading < headings; ++heading) {
      numbers_[{x, y, heading}] = static_cast<Berth>(numbers_.size());
    }
    headings_[{x, y}] = headings;
  }
  std::vector<Berth> on(int x, int y) const {
    std::vector<Berth> berths;
    for (std::uint8_t heading = 0; heading < headings_.at({x, y}); ++heading) {
      berths.push_back(numbers_.at({x, y, heading}));
    }
    return berths;
  }
  bool is_crossing(int x, int y) const { return headings_.at({x, y}) > kSides; }
  void lie_beside(const Square& here, Berth berth) {
    beside_[berth] = on(std::get<0>(here), std::get<1>(here));
    std::erase(beside_[berth], berth);
  }
  void join(const Square& here, Berth from) {
    const auto [x, y, heading] = here;
    if (is_crossing(x, y)) return leave(from, x, y, static_cast<std::uint8_t>(heading % kSides));
    for (const int turn : {0, 1, 3}) leave(from, x, y, static_cast<std::uint8_t>((heading + turn) % kSides));
  }
  /// Adds the drives that leave the square with that heading: one, or one a way that leads on where it is a crossing.
  void leave(Berth from, int x, int y, std::uint8_t side) {
    constexpr std::array<std::array<int, 2>, kSides> steps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    x += steps[side][0];
    y += steps[side][1];
    if (!headings_.contains({x, y})) return;
    if (!is_crossing(x, y)) return drive(from, {x, y, side});
    for (const int turn : {0, 1, 3}) {
      drive(from, {x, y, static_cast<std::uint8_t>(side * kSides + (side + turn) % kSides)});
    }
  }
  void drive(Berth from, const Square& there) {
    const Berth to = numbers_.at(there);
    next_[from].push_back(
        {.to = to, .length_m = 1.0, .middle = middles_++, .touches = on(std::get<0>(there), std::get<1>(there))});
    before_[to].push_back({from, 1.0});
  }

  std::map<std::pair<int, int>, std::uint8_t> headings_;  ///< how many berths a square has
  std::map<Square, Berth> numbers_;
  std::vector<std::vector<BerthArc>> next_;
  std::vector<std::vector<Before>> before_;
  std::vector<std::vector<Berth>> beside_;
  Berth middles_ = 0;
};

}  // namespace weft::server::test
