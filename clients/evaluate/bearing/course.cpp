#include "clients/evaluate/bearing/course.hpp"

#include <algorithm>
#include <utility>

namespace weft::evaluate::bearing {

using namespace agents;

namespace {

constexpr int kLastViewAtMost = 10;  // samples for the last place
constexpr int kSettles = 20;         // samples for the camera to find its exposure, as an agent that has been on has
const ExperienceId kExperience{1};
const RobotId kTeacher{{1}};

/// Returns the edge that joins the end of the run to its beginning. None: it was not found to come back.
std::optional<Edge> closing_edge(const TaughtMap& map, const PlaceId& last) {
  std::optional<Edge> closing;
  map.snapshot().for_each_edge(last, [&](const Edge& edge) {
    if (edge.origin == Origin::stitch && edge.id.b == last) closing = edge;
  });
  return closing;
}

}  // namespace

double Course::round_m() const {
  return length_m + planar(relations.back()).x - along_m[closes_at];
}

Pose2 Course::site_from_path(std::size_t place, double beyond_m) const {
  const std::size_t last = places.size() - 1;
  // The end may have been found to lie a little beyond where it comes back to.
  const auto hop_m = [&](std::size_t at) { return planar(relations[at]).x; };
  std::size_t at = place;
  double left_m = beyond_m;
  while (left_m < 0.0) {
    // The way may begin before the place that its end comes back to.
    if (at == 0) left_m -= along_m[closes_at];
    at = at == 0 || at == closes_at ? last : at - 1;
    left_m += hop_m(at);
  }
  while (left_m > std::max(0.0, hop_m(at))) {
    left_m -= hop_m(at);
    at = at == last ? closes_at : at + 1;
  }
  const Pose2& from = site_from_place[at];
  const std::size_t next = at == last ? closes_at : at + 1;
  return from * se2_exp(left_m / std::max(hop_m(at), 1e-6) * se2_log(from.inverse() * site_from_place[next]));
}

Route Course::loops(std::size_t count) const {
  Route route;
  route.id.bytes[0] = 1;
  for (std::size_t loop = 0; loop < count; ++loop) {
    for (std::size_t i = loop == 0 ? 0 : closes_at; i < places.size(); ++i) {
      route.places.push_back(places[i]);
      route.relations.push_back(relations[i]);
    }
  }
  route.places.push_back(places[closes_at]);
  route.released = static_cast<std::uint32_t>(route.places.size() - 1);
  return route;
}

Result<std::optional<Course>> teach(const Drive& drive, const std::vector<SitePoint>& line) {
  auto body = sim::make_sim_body(drive.body);
  if (!body) return fail(body.error());
  auto navigator = make_navigator((*body)->rig().camera(), Parts::all);
  if (!navigator) return fail(navigator.error());
  Course course;
  const auto step = [&]() -> Result<std::pair<Navigated, bool>> {
    const Result<Sample> sample = (*body)->step({});
    if (!sample) return fail(sample.error());
    Navigated now = (*navigator)->step(*sample, course.map.view());
    expose(**body, now);
    return std::pair(std::move(now), sample->hand_done);
  };
  for (int i = 0; i < kSettles; ++i)
    if (const auto looked = step(); !looked) return fail(looked.error());
  if (const Result<void> begun = (*body)->drive_by_hand(line); !begun) return fail(begun.error());
  (*navigator)->begin_teach({kExperience, kTeacher});
  const auto take = [&](const std::vector<Kept>& kept) {
    for (const Kept& one : kept) {
      course.places.push_back(one.place.id);
      course.site_from_place.push_back((*body)->site_from_robot());
    }
    return course.map.take(kExperience, kTeacher, Bearing::name, kept);
  };
  int ending = 0;
  for (bool done = false; !done;) {
    if (drive.asked_to_stop()) return std::optional<Course>();
    const auto stepped = step();
    if (!stepped) return fail(stepped.error());
    const auto& [now, hand_done] = *stepped;
    if (const Result<void> taken = take(now.kept); !taken) return fail(taken.error());
    if (!hand_done) continue;
    if (const Result<void> taken = take((*navigator)->end_teach(course.map.view())); !taken)
      return fail(taken.error());
    done = !(*navigator)->is_taught() || ++ending > kLastViewAtMost;
  }
  const std::optional<Edge> closing = closing_edge(course.map, course.places.back());
  if (!closing) return fail(ErrorCode::refused, "the end of what was taught was not found to come back to its start");
  for (std::size_t i = 0; i + 1 < course.places.size(); ++i) {
    const Edge* const edge = course.map.view().window.edges.value({course.places[i], course.places[i + 1]});
    course.relations.push_back(edge->a_from_b);
    course.along_m.push_back(course.length_m);
    course.length_m += distance_m(edge->a_from_b);
  }
  course.along_m.push_back(course.length_m);
  course.relations.push_back(inverse(closing->a_from_b));
  course.closes_at = closing->id.a.index;
  return std::optional(std::move(course));
}

}  // namespace weft::evaluate::bearing
