// Relates a view to the mosaic around the robot in place of to one view of a place.
#include <utility>

#include "agents/methods/ceiling/ceiling.hpp"

namespace weft::agents {
namespace {

Metric2 in_plane_of(const Relation& relation) {
  return {planar(relation), planar_covariance(relation)};
}

/// Returns how far from a robot its camera is believed to show the ceiling.
double charted_reach_m(const CeilingConfig& config, const CeilingContent& content) {
  return config.reach_heights * (content.ceiling_m - content.camera.robot_from_camera.translation.z());
}

/// Returns the mosaic about the robot as a place that stood in its middle would have stored it.
CeilingContent laid_about(const CeilingConfig& config, const CeilingChart& chart, const ChartedCeiling& place,
                          const Eigen::Vector2d& robot_in_centre) {
  constexpr std::size_t spare = 2;  // times as many as a view has: views choose differently
  CeilingContent laid;
  laid.camera = place.content->camera;
  laid.attitude_sigma = place.content->attitude_sigma;
  laid.ceiling_m = chart.ceiling_m;
  laid.ceiling_sigma_m = place.content->ceiling_sigma_m;
  laid.features = chart.around(robot_in_centre, charted_reach_m(config, laid), spare * most_ceiling_features,
                               place.centre_from_place);
  return laid;
}

}  // namespace

static_assert(ChartsItself<Ceiling>);

CeilingChart Ceiling::chart(const std::vector<ChartPlace<Content>>& around) const {
  return chart_ceiling(config_, around);
}

Ceiling::Belief Ceiling::begin(const Chart& chart, const Estimate& seed) const {
  Metric2 centre_from_robot = in_plane_of(seed.place_from_robot);
  if (const ChartedCeiling* const place = chart.find(seed.place))
    centre_from_robot.a_from_b = place->centre_from_place * centre_from_robot.a_from_b;
  return {centre_from_robot};
}

Ceiling::Belief Ceiling::believed(const Chart& chart, const Belief&, const Estimate& estimate) const {
  return begin(chart, estimate);
}

Located<Ceiling::Belief> Ceiling::locate(const Chart& chart, Belief belief, const Step& step,
                                         const Content& seen) const {
  belief.centre_from_robot = in_plane_of(compose(belief.centre_from_robot, step.previous_from_current));
  Located<Belief> located{belief, std::nullopt, {}};
  const Eigen::Vector2d robot = belief.centre_from_robot.a_from_b.translation();
  const ChartedCeiling* const place = chart.nearest(robot);
  if (place == nullptr) {
    located.refusals.push_back({"nothing_near"});
    return located;
  }
  constexpr double most_of_reach = 0.5;  // farther aside, little of what is seen is charted
  const double apart_m = (place->centre_from_place.translation() - robot).norm();
  const double most_m = most_of_reach * charted_reach_m(config_, *place->content);
  if (apart_m > most_m) {
    located.refusals.push_back({"nothing_near", apart_m, most_m});
    return located;
  }
  const Metric2 guess{place->centre_from_place.inverse() * belief.centre_from_robot.a_from_b,
                      belief.centre_from_robot.covariance};
  OrRefusal<Related> related = relate(laid_about(config_, chart, *place, robot), seen, guess);
  if (!related) {
    located.refusals.push_back(related.error());
    related = relate(*place->content, seen, guess);
  }
  if (!related) {
    located.refusals.push_back(related.error());
    return located;
  }
  located.belief.centre_from_robot = in_plane_of(related->a_from_b);
  located.belief.centre_from_robot.a_from_b = place->centre_from_place * located.belief.centre_from_robot.a_from_b;
  located.fix = Fix{place->id, related->a_from_b, *std::move(related)};
  return located;
}

}  // namespace weft::agents
