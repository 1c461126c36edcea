#pragma once
#include <memory>

#include "core/network/routing/preparation.hpp"
#include "tests/support/site_network.hpp"

namespace weft::routing {

/// Searches with boost::graph::astar_search over a compressed graph of the same arcs. Its heuristic is the distance
/// between the true positions (which no network knows), scaled so that it never says more than an arc costs.
class BoostAstar {
 public:
  BoostAstar(const Preparation& preparation, support::TruePoses truth);
  ~BoostAstar();
  /// Returns the cost of the cheapest way; infinity: there is no way.
  double cost(const PlaceId& from, const PlaceId& to) const;

 private:
  struct Graph;
  std::unique_ptr<Graph> graph_;
};

}  // namespace weft::routing
