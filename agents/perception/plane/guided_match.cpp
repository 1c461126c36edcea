#include "agents/perception/plane/guided_match.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace weft::agents {
namespace {

constexpr double kCell_m = 0.1;

/// Sorts a's features into cells of the plane, to ask for those near a point: each cell's stand side by side in
/// memory, as they are asked for tens of thousands of times.
class PlaneCells {
 public:
  struct Entry {
    Eigen::Vector2d at;
    double heading_rad = 0.0;
    std::uint32_t index = 0;
  };

  PlaneCells(const LevelFeatures& of, double cell_m) : cell_m_(cell_m) {
    for (std::uint32_t i = 0; i < of.at.size(); ++i)
      if (is_near(of.at[i])) entries_.push_back({of.at[i], of.features[i].heading_rad, i});
    if (entries_.empty()) return;
    low_ = high_ = entries_.front().at;
    for (const Entry& entry : entries_) {
      low_ = low_.cwiseMin(entry.at);
      high_ = high_.cwiseMax(entry.at);
    }
    columns_ = column(high_.x()) + 1;
    const auto cell_of = [&](const Entry& entry) { return row(entry.at.y()) * columns_ + column(entry.at.x()); };
    std::stable_sort(entries_.begin(), entries_.end(),
                     [&](const Entry& one, const Entry& other) { return cell_of(one) < cell_of(other); });
    begins_.assign(static_cast<std::size_t>(columns_ * (row(high_.y()) + 1)) + 1, 0);
    for (const Entry& entry : entries_) ++begins_[static_cast<std::size_t>(cell_of(entry)) + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  }

  /// Calls `visit(entry)` for each feature within `reach_m`.
  template <class Visit>
  void near(const Eigen::Vector2d& point, double reach_m, const Visit& visit) const {
    if (entries_.empty() || !is_near(point)) return;
    const Eigen::Vector2d from = (point.array() - reach_m).max(low_.array());
    const Eigen::Vector2d to = (point.array() + reach_m).min(high_.array());
    if (from.x() > to.x() || from.y() > to.y()) return;
    for (int r = row(from.y()); r <= row(to.y()); ++r) {  // of a row, one stretch of entries
      const std::size_t first = begins_[static_cast<std::size_t>(r * columns_ + column(from.x()))];
      const std::size_t end = begins_[static_cast<std::size_t>(r * columns_ + column(to.x())) + 1];
      for (std::size_t k = first; k < end; ++k)
        if ((entries_[k].at - point).squaredNorm() < reach_m * reach_m) visit(entries_[k]);
    }
  }

 private:
  /// Returns whether a point is within 20 m: a damaged or foreign content may put a feature at its horizon.
  static bool is_near(const Eigen::Vector2d& point) { return point.allFinite() && point.norm() < 20.0; }
  int column(double x) const { return static_cast<int>((x - low_.x()) / cell_m_); }
  int row(double y) const { return static_cast<int>((y - low_.y()) / cell_m_); }

  double cell_m_;
  std::vector<Entry> entries_;       // cell by cell
  std::vector<std::size_t> begins_;  // of each cell's entries, and where the last one's end
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d high_ = Eigen::Vector2d::Zero();
  int columns_ = 0;
};

}  // namespace

std::vector<Match> guided_matches(const LevelFeatures& a, const LevelFeatures& b, const MatchGate& gate,
                                  const MatchBounds& bounds, double slack_m) {
  // A feature's own heading is noisier than a robot's; half a radian keeps nine tenths of the right ones.
  const double heading_gate = gate.heading_rad + 0.5;
  const PlaneCells cells(a, kCell_m);
  std::vector<std::vector<std::uint32_t>> candidates(b.at.size());
  for (std::size_t j = 0; j < b.at.size(); ++j) {
    const Eigen::Vector2d expected = gate.a_from_b * b.at[j];
    const double reach = gate.distance_m + std::sin(std::min(gate.heading_rad, 1.5)) * b.at[j].norm() + slack_m;
    const double heading = wrap_angle(b.features[j].heading_rad + gate.a_from_b.heading);
    cells.near(expected, reach, [&](const PlaneCells::Entry& entry) {
      const double turned = std::abs(entry.heading_rad - heading);  // of two headings: less than a whole turn
      if (std::min(turned, 2.0 * std::numbers::pi - turned) < heading_gate) candidates[j].push_back(entry.index);
    });
  }
  return match_descriptors(descriptors_of(a.features), descriptors_of(b.features), bounds, candidates);
}

}  // namespace weft::agents
