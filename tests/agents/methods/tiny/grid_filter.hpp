#pragma once
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "tests/support/marks.hpp"

namespace weft::agents::tiny {

/// Localises by a particle filter on an occupancy grid: marks are mere points here, their numbers are not used for
/// it.
class GridFilter {
 public:
  static constexpr std::string_view name = "grid-filter";
  static constexpr std::uint32_t content_format = 1;
  static constexpr ChartSize chart_size = {12, 200};
  using Content = MarksMethod::Content;
  using Odometry = MarksMethod::Odometry;

  struct Chart {
    std::map<std::pair<int, int>, double> occupied;  // cells of cell_m, in the frame of the centre; likelihood
    std::vector<std::pair<PlaceId, Relation>> centre_from_places;
  };
  struct Particle {
    Pose2 centre_from_robot;
    double weight = 1.0;
  };
  struct Belief {
    std::vector<Particle> particles;
    Random random{1};
  };

  Step observe(Odometry& odometry, const View* view, const Motion& motion) const {
    return marks_.observe(odometry, view, motion);
  }
  OrRefusal<Content> extract(const Odometry& odometry, const View& view) const {
    return marks_.extract(odometry, view);
  }
  Bytes encode(const Content& content) const { return marks_.encode(content); }
  Result<Content> decode(ByteView bytes) const { return marks_.decode(bytes); }
  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const {
    return marks_.relate(a, b, guess);
  }
  std::optional<Signature> sign(const Content&) const { return std::nullopt; }

  Chart chart(const std::vector<ChartPlace<Content>>& around) const {
    Chart chart;
    for (const ChartPlace<Content>& place : around) {
      chart.centre_from_places.emplace_back(place.id, place.centre_from_place);
      if (!place.content) continue;
      for (const Marks::Sighting& seen : place.content->sightings) {
        const Pose2 centre_from_mark = planar(place.centre_from_place) * seen.robot_from_mark;
        const auto [column, row] = cell(centre_from_mark.x, centre_from_mark.y);
        for (int dx = -1; dx <= 1; ++dx) {
          for (int dy = -1; dy <= 1; ++dy) {
            double& value = chart.occupied[{column + dx, row + dy}];
            value = std::max(value, dx == 0 && dy == 0 ? 1.0 : 0.5);
          }
        }
      }
    }
    return chart;
  }

  /// Returns the belief as it is. In `begin`, `seed` is a place of the chart: its centre, as navigation makes it.
  Belief believed(const Chart&, const Belief& belief, const Estimate&) const { return belief; }
  Belief begin(const Chart& chart, const Estimate& seed) const {
    Belief belief;
    for (const auto& [id, centre_from_place] : chart.centre_from_places) {
      if (id != seed.place) continue;
      const Pose2 mean = planar(compose(centre_from_place, seed.place_from_robot));
      for (int i = 0; i < particle_count; ++i) {
        belief.particles.push_back({mean * Pose2{belief.random.normal(0, 0.04), belief.random.normal(0, 0.04),
                                                 belief.random.normal(0, 0.04)}});
      }
    }
    return belief;
  }

  Located<Belief> locate(const Chart& chart, Belief belief, const Step& step, const Content& seen) const {
    if (belief.particles.empty()) return {std::move(belief), std::nullopt, {{"no_particles"}}};
    const Pose2 moved = planar(step.previous_from_current);
    double best = 0.0;
    double sum = 0.0;
    for (Particle& particle : belief.particles) {
      particle.centre_from_robot =
          particle.centre_from_robot * moved *
          Pose2{belief.random.normal(0, 0.008), belief.random.normal(0, 0.008), belief.random.normal(0, 0.008)};
      const double hits = matches(chart, particle.centre_from_robot, seen);
      best = std::max(best, hits / static_cast<double>(seen.sightings.size()));
      particle.weight = std::exp(1.5 * hits);
      sum += particle.weight;
    }
    constexpr double least_hits = 0.4;
    if (best < least_hits) return {std::move(belief), std::nullopt, {{"few_cells_match", best, least_hits}}};
    const Metric2 mean = resample(belief, sum);
    constexpr double widest_m = 0.1;
    const double spread = std::sqrt(std::max(mean.covariance(0, 0), mean.covariance(1, 1)));
    if (spread > widest_m) return {std::move(belief), std::nullopt, {{"particles_spread", spread, widest_m}}};
    Fix fix = nearest_place(chart, mean);
    fix.evidence.overlap = std::min(best, 1.0);
    return {std::move(belief), fix, {}};
  }

 private:
  static constexpr double cell_m = 0.03;
  static constexpr int particle_count = 150;

  static std::pair<int, int> cell(double x, double y) {
    return {static_cast<int>(std::floor(x / cell_m)), static_cast<int>(std::floor(y / cell_m))};
  }

  static double matches(const Chart& chart, const Pose2& centre_from_robot, const Content& seen) {
    double hits = 0.0;
    for (const Marks::Sighting& mark : seen.sightings) {
      const Eigen::Vector2d point = centre_from_robot * mark.robot_from_mark.translation();
      const auto found = chart.occupied.find(cell(point.x(), point.y()));
      if (found != chart.occupied.end()) hits += found->second;
    }
    return hits;
  }

  /// Resamples with low variance; returns the weighted mean and covariance of the particles as they were before.
  static Metric2 resample(Belief& belief, double sum) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    const Pose2 first = belief.particles.front().centre_from_robot;
    for (const Particle& one : belief.particles) {
      mean += one.weight / sum * se2_log(first.inverse() * one.centre_from_robot);
    }
    Metric2 result{first * se2_exp(mean), 1e-5 * Eigen::Matrix3d::Identity()};
    for (const Particle& one : belief.particles) {
      const Eigen::Vector3d apart = se2_log(result.a_from_b.inverse() * one.centre_from_robot);
      result.covariance += one.weight / sum * apart * apart.transpose();
    }
    std::vector<Particle> drawn;
    double at = belief.random.uniform() * sum / particle_count;
    double passed = belief.particles.front().weight;
    std::size_t i = 0;
    while (drawn.size() < belief.particles.size()) {
      while (at > passed && i + 1 < belief.particles.size()) passed += belief.particles[++i].weight;
      drawn.push_back({belief.particles[i].centre_from_robot});
      at += sum / particle_count;
    }
    belief.particles = std::move(drawn);
    return result;
  }

  static Fix nearest_place(const Chart& chart, const Metric2& centre_from_robot) {
    Fix fix;
    double nearest = 1e9;
    for (const auto& [id, centre_from_place] : chart.centre_from_places) {
      const Relation place_from_robot = compose(inverse(centre_from_place), centre_from_robot);
      if (norm(place_from_robot) >= nearest) continue;
      nearest = norm(place_from_robot);
      fix.place = id;
      // The map's uncertainty belongs to the generic code; the filter answers for its own.
      fix.place_from_robot = Metric2{planar(place_from_robot), centre_from_robot.covariance};
    }
    return fix;
  }

  MarksMethod marks_;
};

static_assert(ChartsItself<GridFilter>);

}  // namespace weft::agents::tiny
