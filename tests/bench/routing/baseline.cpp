#include "tests/bench/routing/baseline.hpp"

#include <algorithm>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <cmath>

namespace weft::routing {
namespace {

struct Cost {
  double weight = 0.0;
};
using Csr = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Cost>;
using Vertex = boost::graph_traits<Csr>::vertex_descriptor;

struct Found {};

class Heuristic : public boost::astar_heuristic<Csr, double> {
 public:
  Heuristic(const std::vector<Pose2>& poses, Vertex goal, double scale) : poses_(poses), goal_(goal), scale_(scale) {}
  double operator()(Vertex at) const {
    return scale_ * std::hypot(poses_[at].x - poses_[goal_].x, poses_[at].y - poses_[goal_].y);
  }

 private:
  const std::vector<Pose2>& poses_;
  Vertex goal_;
  double scale_;
};

class StopAt : public boost::default_astar_visitor {
 public:
  explicit StopAt(Vertex goal) : goal_(goal) {}
  void examine_vertex(Vertex vertex, const Csr&) const {
    if (vertex == goal_) throw Found();
  }

 private:
  Vertex goal_;
};

}  // namespace

struct BoostAstar::Graph {
  Csr csr;
  std::vector<PlaceId> ids;  ///< ascending
  std::vector<Pose2> poses;
  double scale = 1.0;

  Vertex vertex(const PlaceId& id) const {
    return static_cast<Vertex>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
  }
};

BoostAstar::BoostAstar(const Preparation& preparation, support::TruePoses truth) : graph_(std::make_unique<Graph>()) {
  std::sort(truth.begin(), truth.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [id, pose] : truth) {
    graph_->ids.push_back(id);
    graph_->poses.push_back(pose);
  }
  std::vector<std::pair<Vertex, Vertex>> arcs;
  std::vector<Cost> costs;
  for (const auto& base : preparation.base) {
    for (std::uint32_t slot = 0; slot < base->places.size(); ++slot) {
      const Vertex from = graph_->vertex(base->places[slot]);
      for (std::uint32_t at = base->first_arc[slot]; at < base->first_arc[slot + 1]; ++at) {
        const Vertex to = graph_->vertex(preparation.place(base->arcs[at].to));
        const double apart =
            std::hypot(graph_->poses[from].x - graph_->poses[to].x, graph_->poses[from].y - graph_->poses[to].y);
        if (apart > 0.0) graph_->scale = std::min(graph_->scale, base->arcs[at].cost / apart);
        arcs.emplace_back(from, to);
        costs.push_back({base->arcs[at].cost});
      }
    }
  }
  graph_->csr =
      Csr(boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(), costs.begin(), graph_->ids.size());
}

BoostAstar::~BoostAstar() = default;

double BoostAstar::cost(const PlaceId& from, const PlaceId& to) const {
  const Vertex goal = graph_->vertex(to);
  std::vector<double> distances(graph_->ids.size());
  std::vector<Vertex> parents(graph_->ids.size());
  try {
    boost::astar_search(graph_->csr, graph_->vertex(from), Heuristic(graph_->poses, goal, graph_->scale),
                        boost::visitor(StopAt(goal))
                            .predecessor_map(boost::make_iterator_property_map(
                                parents.begin(), boost::get(boost::vertex_index, graph_->csr)))
                            .distance_map(boost::make_iterator_property_map(
                                distances.begin(), boost::get(boost::vertex_index, graph_->csr)))
                            .weight_map(boost::get(&Cost::weight, graph_->csr)));
  } catch (const Found&) {
    return distances[goal];
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace weft::routing
