#include "tests/bench/traffic/taught_lanes.hpp"

#include <cmath>
#include <utility>

namespace weft::bench {
namespace {

constexpr double kAside_m = 0.25;
constexpr double kSigma_m = 1e-3;

Place place_of(const PlaceId& id) {
  Place place;
  place.id = id;
  place.method = "marks";
  return place;
}

/// Relates two places; all are turned alike: what counts is where they lie.
Relation relation_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  Metric2 relation{{b.x() - a.x(), b.y() - a.y(), 0.0}, Eigen::Matrix3d::Zero()};
  relation.covariance.diagonal() = Eigen::Vector3d::Constant(kSigma_m * kSigma_m);
  relation.covariance(2, 2) = 1e-10;
  return relation;
}

Edge edge_of(const PlaceId& a, const PlaceId& b, const Relation& relation, Origin origin) {
  Edge edge;
  edge.id = {a, b};
  edge.a_from_b = relation;
  edge.origin = origin;
  edge.method = "marks";
  return edge;
}

}  // namespace

TaughtLanes::TaughtLanes(const Network& network) : network_(network) {
  Batch cells;
  cells.experience = ExperienceId{1};
  cells.method = "marks";
  for (Cell cell = 0; cell < network.size(); ++cell) cells.places.push_back(place_of(place(cell)));
  Batch between;
  between.experience = ExperienceId{2};
  between.method = "marks";
  for (Cell cell = 0; cell < network.size(); ++cell) {
    for (const Cell next : network.next[cell]) {
      const auto first = static_cast<std::uint32_t>(lane_at_.size());
      lanes_[{cell, next}] = first;
      const Eigen::Vector2d way = network.at[next] - network.at[cell];
      const double aside_m = network.leads(next, cell) ? kAside_m : 0.0;
      const Eigen::Vector2d aside = aside_m * Eigen::Vector2d(way.y(), -way.x()).normalized();
      for (std::uint32_t i = 1; i < kPlacesOfCell; ++i) {
        const PlaceId id{between.experience, static_cast<std::uint32_t>(lane_at_.size())};
        lane_at_.emplace_back(network.at[cell] + way * i / kPlacesOfCell + aside);
        between.places.push_back(place_of(id));
        if (i == 1) continue;
        const PlaceId before{id.experience, id.index - 1};
        between.edges.push_back(
            edge_of(before, id, relation_between(lane_at_[id.index - 1], lane_at_[id.index]), Origin::odometry));
      }
      const std::uint32_t last = first + kPlacesOfCell - 2;
      between.edges.push_back(edge_of(place(cell), {between.experience, first},
                                      relation_between(network.at[cell], lane_at_[first]), Origin::stitch));
      between.edges.push_back(edge_of(place(next), {between.experience, last},
                                      relation_between(network.at[next], lane_at_[last]), Origin::stitch));
      between.edges.back().drivable = Drivable::b_to_a;
    }
  }
  batches_ = {std::move(cells), std::move(between)};
  for (const Batch& batch : batches_) snapshot_ = with(snapshot_, batch);
}

const Eigen::Vector2d& TaughtLanes::at(const PlaceId& place) const {
  return place.experience == ExperienceId{1} ? network_.at[place.index] : lane_at_[place.index];
}

Route TaughtLanes::route(const std::vector<Cell>& cells) const {
  Route route;
  route.made_of = snapshot_.revision();
  route.places.push_back(place(cells.front()));
  const auto go_to = [&](const PlaceId& next) {
    route.relations.push_back(relation_between(at(route.places.back()), at(next)));
    route.places.push_back(next);
  };
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const std::uint32_t first = lanes_.at({cells[i - 1], cells[i]});
    for (std::uint32_t k = 0; k + 1 < kPlacesOfCell; ++k) go_to({ExperienceId{2}, first + k});
    go_to(place(cells[i]));
  }
  return route;
}

}  // namespace weft::bench
