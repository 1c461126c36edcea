#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agents/bodies/body.hpp"
#include "clients/evaluate/taught_map.hpp"
#include "clients/evaluate/topometric/ride.hpp"
#include "core/result.hpp"

namespace weft::evaluate::topometric {

/// Holds one run that a robot was taught.
struct Run {
  ExperienceId experience;
  Moments moments;
  std::vector<PlaceId> places;  ///< in the order they were kept
};

/// Holds what robots were taught, and where its places truly are: that is for judging, nobody else sees it.
struct Taught {
  TaughtMap map;
  TaughtMap unregistered;  ///< the same with each edge as it was before two contents were compared
  TruePlaces site_from_place;
  std::vector<Run> runs;

  /// Returns the places of all runs in their order.
  std::vector<PlaceId> places() const;
  /// Returns the place that was truly taught nearest to there. There is one.
  PlaceId nearest(const Eigen::Vector2d& in_site) const;
};

/// Teaches a robot that a hand leads along the line, one more run: it is told nothing of where it begins, and finds
/// out by itself where it joins what was taught before. False: stopped. Errors of body and method; internal: a batch
/// that the server would refuse.
Result<bool> teach(const Rider& rider, const std::vector<agents::SitePoint>& line, Taught& taught);

/// Returns the site with the rider's robot on the line's beginning.
agents::sim::Site on_beginning(const agents::sim::Site& site, const std::string& robot,
                               const std::vector<agents::SitePoint>& line);

}  // namespace weft::evaluate::topometric
