#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"

namespace weft::server::test {

/// Holds berths in squares, as drawn: a row of text each, '.' a berth. Robots drive between neighbours, both ways
/// unless `one_way` says otherwise; nobody touches anything but the square to which it drives, unless `touch` says
/// so.
class DrawnGraph final : public BerthGraph {
 public:
  explicit DrawnGraph(const std::vector<std::string>& rows) {
    for (int y = 0; y < static_cast<int>(rows.size()); ++y) {
      for (int x = 0; x < static_cast<int>(rows[y].size()); ++x) {
        if (rows[y][x] == '.') numbers_.try_emplace({x, y}, static_cast<Berth>(numbers_.size()));
      }
    }
    next_.resize(numbers_.size());
    before_.resize(numbers_.size());
    middles_ = static_cast<Berth>(numbers_.size());
    for (const auto& [here, from] : numbers_) {
      for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}}) {
        const auto there = numbers_.find({here.first + dx, here.second + dy});
        if (there != numbers_.end()) join(from, there->second);
      }
    }
  }

  Berth at(int x, int y) const { return numbers_.at({x, y}); }
  void one_way(Berth from, Berth to) {
    std::erase_if(next_[to], [from](const BerthArc& arc) { return arc.to == from; });
    std::erase_if(before_[from], [to](const Before& before) { return before.from == to; });
  }

  /// Has who drives there touch another square, too.
  void touch(Berth from, Berth to, Berth other) {
    for (BerthArc& arc : next_[from]) {
      if (arc.to == to) arc.touches.push_back(other);
    }
  }

  /// Has nobody stand in one of the squares while another one does in the other.
  void lay_beside(Berth one, Berth other) {
    beside_[one].push_back(other);
    beside_[other].push_back(one);
  }

  const std::vector<BerthArc>& next(Berth from, std::uint32_t /*methods*/) override { return next_[from]; }
  const std::vector<Before>& before(Berth to, std::uint32_t /*methods*/) override { return before_[to]; }
  const std::vector<Berth>& beside(Berth berth) override { return beside_[berth]; }
  bool is_cut(Berth berth) const override { return berth < next_.size(); }
  std::size_t size() const override { return middles_; }

 private:
  void join(Berth from, Berth to) {
    next_[from].push_back({.to = to, .length_m = 1.0, .middle = middles_++, .touches = {to}});
    before_[to].push_back({from, 1.0});
  }

  std::map<std::pair<int, int>, Berth> numbers_;
  std::vector<std::vector<BerthArc>> next_;
  std::vector<std::vector<Before>> before_;
  std::map<Berth, std::vector<Berth>> beside_;
  Berth middles_ = 0;
};

}  // namespace weft::server::test
