#include "clients/evaluate/floor/attempts/relating.hpp"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace weft::evaluate::floor {
namespace {

using namespace agents;
using Known = KnownPlaces::Known;

Metric2 guess_of(const Pose2& place_from_robot, double sigma_m, double sigma_rad) {
  return {place_from_robot,
          Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad).asDiagonal()};
}

/// Draws a guess that is off by what it says of itself.
Metric2 honest_guess(const Pose2& truth, Random& random) {
  const double sigma_m = random.uniform(0.005, 0.15);
  const double sigma_rad = random.uniform(0.005, 0.10);
  const Pose2 off{sigma_m * random.normal(), sigma_m * random.normal(), sigma_rad * random.normal()};
  return guess_of(truth * off, sigma_m, sigma_rad);
}

/// Draws a guess off by far more: anywhere, or half the time by whole tiles, where repeating floors look the same.
Metric2 lying_guess(const Pose2& site_from_place, const Pose2& site_from_robot, Random& random) {
  constexpr double kTileM = 0.3;
  Pose2 believed = site_from_robot;
  if (random.chance(0.5)) {
    const double along = kTileM * static_cast<double>(1 + random.below(3));
    const bool is_x = random.chance(0.5);
    const double sign = random.chance(0.5) ? 1.0 : -1.0;
    (is_x ? believed.x : believed.y) += sign * along + 0.02 * random.normal();
    (is_x ? believed.y : believed.x) += 0.02 * random.normal();
  } else {
    const double towards = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double away_m = random.uniform(0.25, 1.0);
    believed = believed * Pose2{away_m * std::cos(towards), away_m * std::sin(towards), 0.1 * random.normal()};
  }
  return guess_of(site_from_place.inverse() * believed, random.uniform(0.005, 0.05), 0.02);
}

/// Relates one view to whatever places are drawn for it.
class Attempts {
 public:
  Attempts(const Floor& method, const KnownPlaces& places, const Shows& view, Random& random, Tally& tally)
      : method_(method), places_(places), view_(view), random_(random), tally_(tally) {}

  void with_right_answers() {
    const std::vector<std::size_t> near = places_.that_share(view_, method_.config().kappa);
    if (near.empty()) return;
    const auto drawn = [&]() -> const Known& { return places_.all()[near[random_.below(near.size())]]; };
    const Known& unguided = drawn();
    remember(attempted::kNear, unguided, relate(attempted::kNear, unguided, std::nullopt, truth_of(unguided)));
    const Known& guided = drawn();
    remember(attempted::kNearGuided, guided,
             relate(attempted::kNearGuided, guided, honest_guess(truth_of(guided), random_), truth_of(guided)));
    const Known& lied = drawn();
    relate(attempted::kWrongGuess, lied, lying_guess(lied.shows.site_from_robot, view_.site_from_robot, random_),
           truth_of(lied));
  }

  /// Relates it to places that show none of what is seen.
  void without() {
    const std::vector<std::size_t> far = places_.that_share_nothing(view_);
    if (far.empty()) return;
    const auto drawn = [&]() -> const Known& { return places_.all()[far[random_.below(far.size())]]; };
    const Known& any = drawn();
    relate(attempted::kElsewhere, any, std::nullopt, truth_of(any));
    guess_here(attempted::kElsewhereGuided, drawn(), true);
    if (const std::optional<Signature> signature = method_.sign(view_.content)) {
      const Known& alike = places_.all()[places_.alike(far, *signature, random_)];
      relate(attempted::kLookAlike, alike, std::nullopt, truth_of(alike));
    }
  }

  /// Relates it to any place at all, when what is seen is on another floor.
  void other_floor() {
    const auto drawn = [&]() -> const Known& { return places_.all()[random_.below(places_.all().size())]; };
    relate(attempted::kOtherFloor, drawn(), std::nullopt, std::nullopt);
    guess_here(attempted::kOtherFloor, drawn(), false);
  }

  void mirrored(const FloorContent& mirrored) {
    const std::vector<std::size_t> near = places_.that_share(view_, method_.config().kappa);
    if (near.empty()) return;
    const Known& place = places_.all()[near[random_.below(near.size())]];
    count(attempted::kMirrored, place, method_.relate(place.shows.content, mirrored, std::nullopt), std::nullopt);
  }

 private:
  Pose2 truth_of(const Known& place) const { return place.shows.site_from_robot.inverse() * view_.site_from_robot; }

  bool count(const char* sort, const Known& place, const OrRefusal<Related>& related,
             const std::optional<Pose2>& truth) {
    const OrRefusal<Pose2> said =
        related ? OrRefusal<Pose2>(planar(related->a_from_b)) : OrRefusal<Pose2>(tl::unexpected(related.error()));
    tally_.count(sort, said, truth, place.shows.site_from_robot);
    return said && truth && is_right(*said, *truth);
  }
  bool relate(const char* sort, const Known& place, const std::optional<Relation>& guess,
              const std::optional<Pose2>& truth) {
    return count(sort, place, method_.relate(place.shows.content, view_.content, guess), truth);
  }
  void remember(const char* sort, const Known& place, bool is_right) {
    tally_.recall(sort, apart(place.shows, view_), is_right);
  }
  /// Relates it with a guess that the robot stands about where the place was kept.
  void guess_here(const char* sort, const Known& place, bool has_truth) {
    const Pose2 lie{random_.uniform(-0.3, 0.3), random_.uniform(-0.3, 0.3), random_.uniform(-0.3, 0.3)};
    relate(sort, place, guess_of(lie, random_.uniform(0.005, 0.25), 0.05),
           has_truth ? std::optional(truth_of(place)) : std::nullopt);
  }

  const Floor& method_;
  const KnownPlaces& places_;
  const Shows& view_;
  Random& random_;
  Tally& tally_;
};

}  // namespace

void relate_passage(const Floor& method, const KnownPlaces& places, const Passage& passage, bool is_other_floor,
                    Random& random, Tally& tally) {
  for (const Look& look : passage.looks) {
    if (!look.content) continue;
    const Shows view = shows_of(*look.content, look.site_from_robot, method.config().far_m);
    Attempts attempts(method, places, view, random, tally);
    if (is_other_floor) {
      attempts.other_floor();
      continue;
    }
    attempts.with_right_answers();
    attempts.without();
    const bool is_last = &look == &passage.looks.back();
    if (is_last && passage.mirrored) attempts.mirrored(*passage.mirrored);
  }
}

}  // namespace weft::evaluate::floor
