#include "clients/evaluate/topometric/taught.hpp"

#include <algorithm>
#include <utility>

#include "clients/evaluate/scene.hpp"

namespace weft::evaluate::topometric {
namespace {

using namespace agents;

constexpr int kSettlingSamples = 6;  // for the cameras to find their exposure, as an agent that has been on has
constexpr int kLastViewWithin = 10;  // samples

/// Returns an edge as it was before contents were compared; as it is, where they were not.
Edge before_comparing(Edge edge, const Noted& noted) {
  for (const auto* const compared : {&noted.registered, &noted.related})
    for (const Compared& one : *compared)
      if (identical(one.a_from_b, edge.a_from_b)) {
        edge.a_from_b = one.guess;
        return edge;
      }
  return edge;
}

/// Teaches one run.
class RunTeaching {
 public:
  RunTeaching(const Rider& rider, Ride& ride, Taught& taught) : rider_(rider), ride_(ride), taught_(taught) {
    run_.experience = ExperienceId{taught.runs.size() + 1};
    teacher_ = RobotId{{static_cast<std::uint8_t>(run_.experience.value)}};
  }

  Result<bool> lead(const std::vector<SitePoint>& line) {
    if (const Result<void> signs = ride_.learn_signs(taught_.map); !signs) return fail(signs.error());
    for (int i = 0; i < kSettlingSamples; ++i)
      if (const auto stepped = ride_.step(taught_.map); !stepped) return fail(stepped.error());
    if (const Result<void> begun = ride_.body().drive_by_hand(line); !begun) return fail(begun.error());
    ride_.navigator().begin_teach({run_.experience, teacher_});
    int ending = 0;
    for (bool is_done = false; !is_done;) {
      if (rider_.asked_to_stop()) return false;
      const auto stepped = ride_.step(taught_.map);
      if (!stepped) return fail(stepped.error());
      if (const Result<void> taken = take(stepped->navigated.kept); !taken) return fail(taken.error());
      if (!stepped->hand_done) continue;
      const std::vector<Kept> last = ride_.navigator().end_teach(taught_.map.view());
      ride_.note_kept(last);
      if (const Result<void> taken = take(last); !taken) return fail(taken.error());
      is_done = !ride_.navigator().is_taught() || ++ending > kLastViewWithin;
    }
    return finish();
  }

 private:
  Result<void> take(const std::vector<Kept>& kept) {
    std::vector<Kept> unregistered = kept;
    for (Kept& one : unregistered)
      for (Edge& edge : one.edges) edge = before_comparing(std::move(edge), ride_.noted());
    for (const Kept& one : kept) run_.places.push_back(one.place.id);
    const Result<void> taken = taught_.map.take(run_.experience, teacher_, Topometric::name, kept);
    if (!taken) return taken;
    return taught_.unregistered.take(run_.experience, teacher_, Topometric::name, unregistered);
  }

  Result<bool> finish() {
    Result<Moments> moments = ride_.finish();
    if (!moments) return fail(moments.error());
    run_.moments = std::move(*moments);
    for (const Moment& moment : run_.moments)
      if (moment.kept) taught_.site_from_place[*moment.kept] = moment.site_from_robot;
    taught_.runs.push_back(std::move(run_));
    return true;
  }

  const Rider& rider_;
  Ride& ride_;
  Taught& taught_;
  Run run_;
  RobotId teacher_;
};

}  // namespace

std::vector<PlaceId> Taught::places() const {
  std::vector<PlaceId> all;
  for (const Run& run : runs) all.insert(all.end(), run.places.begin(), run.places.end());
  return all;
}

PlaceId Taught::nearest(const Eigen::Vector2d& in_site) const {
  const auto apart_m = [&](const auto& place) { return (place.second.translation() - in_site).norm(); };
  return std::min_element(site_from_place.begin(), site_from_place.end(),
                          [&](const auto& a, const auto& b) { return apart_m(a) < apart_m(b); })
      ->first;
}

Result<bool> teach(const Rider& rider, const std::vector<SitePoint>& line, Taught& taught) {
  auto ride = Ride::make(rider);
  if (!ride) return fail(ride.error());
  return RunTeaching(rider, **ride, taught).lead(line);
}

sim::Site on_beginning(const sim::Site& site, const std::string& robot, const std::vector<SitePoint>& line) {
  return with_start(site, robot, beginning_of(line));
}

}  // namespace weft::evaluate::topometric
