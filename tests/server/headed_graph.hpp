#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"

namespace weft::server::test {

enum class Heading : std::uint8_t { east, south, west, north };

/// Holds squares, as drawn: a row of text each, '.' one robot's room. Robots drive on ahead or turn into a side
/// street; nobody turns round or drives backwards. A berth is a square with the heading of who stands there, and one
/// robot stands on a square.
class HeadedGraph final : public BerthGraph {
 public:
  explicit HeadedGraph(const std::vector<std::string>& rows) {
    for (int y = 0; y < static_cast<int>(rows.size()); ++y) {
      for (int x = 0; x < static_cast<int>(rows[y].size()); ++x) {
        if (rows[y][x] != '.') continue;
        for (std::uint8_t side = 0; side < 4; ++side) numbers_[{x, y, side}] = static_cast<Berth>(numbers_.size());
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
  using Square = std::tuple<int, int, std::uint8_t>;

  void lie_beside(const Square& here, Berth berth) {
    const auto [x, y, heading] = here;
    for (std::uint8_t side = 0; side < 4; ++side) {
      if (side != heading) beside_[berth].push_back(numbers_.at({x, y, side}));
    }
  }
  void join(const Square& here, Berth from) {
    constexpr std::array<std::array<int, 2>, 4> steps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto [x, y, heading] = here;
    for (const int turn : {0, 1, 3}) {
      const auto side = static_cast<std::uint8_t>((heading + turn) % 4);
      const auto there = numbers_.find({x + steps[side][0], y + steps[side][1], side});
      if (there == numbers_.end()) continue;
      std::vector<Berth> touches;
      for (std::uint8_t other = 0; other < 4; ++other) {
        touches.push_back(numbers_.at({std::get<0>(there->first), std::get<1>(there->first), other}));
      }
      next_[from].push_back({.to = there->second, .length_m = 1.0, .middle = middles_++, .touches = touches});
      before_[there->second].push_back({from, 1.0});
    }
  }

  std::map<Square, Berth> numbers_;
  std::vector<std::vector<BerthArc>> next_;
  std::vector<std::vector<Before>> before_;
  std::vector<std::vector<Berth>> beside_;
  Berth middles_ = 0;
};

}  // namespace weft::server::test
