#include "clients/evaluate/topometric/kidnapped_trial.hpp"

#include <numbers>
#include <utility>

#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/topometric/belief_errors.hpp"
#include "clients/evaluate/topometric/spread.hpp"
#include "core/random.hpp"

namespace weft::evaluate::topometric {
namespace {

using namespace agents;

constexpr double kLooksForS = 40.0;
constexpr double kRightM = 0.30;
constexpr double kRightRad = 6.0 * std::numbers::pi / 180.0;
constexpr std::uint64_t kDayOfPutDowns = 1;
constexpr std::uint64_t kPutDownsOfSeed = 79;

/// Tells at which sample the robot came to believe something after it was put down.
struct PutDown {
  double looked_s = 0.0;
  std::optional<std::size_t> believes_at;
};

Pose2 beside_line(const std::vector<SitePoint>& line, bool is_turned, Random& random) {
  constexpr double aside_m = 0.2;
  constexpr double askew_rad = 0.2;
  constexpr double piece_m = 0.1;
  const double at_m = random.uniform(0.0, floor::length_of(line) - piece_m);
  const Pose2 on_line = beginning_of(floor::stretch(line, at_m, at_m + piece_m));
  const double heading = random.uniform(-askew_rad, askew_rad) + (is_turned ? std::numbers::pi : 0.0);
  return on_line * Pose2{0.0, random.uniform(-aside_m, aside_m), wrap_angle(heading)};
}

/// Lets the robot look for itself. None: stopped.
Result<std::optional<PutDown>> look(Ride& ride, const Rider& rider, const Taught& taught) {
  ride.navigator().stop();
  ride.navigator().forget_where();
  ride.navigator().seek(std::nullopt);
  PutDown put_down;
  const double began_s = ride.now_s();
  while (put_down.looked_s < kLooksForS) {
    if (rider.asked_to_stop()) return std::optional<PutDown>();
    if (const auto stepped = ride.step(taught.map); !stepped) return fail(stepped.error());
    put_down.looked_s = ride.now_s() - began_s;
    if (!ride.navigator().estimate()) continue;
    put_down.believes_at = ride.samples() - 1;
    break;
  }
  return std::optional(put_down);
}

}  // namespace

Result<std::optional<Measured>> measure_kidnapped(const sim::Site& site, const std::vector<SitePoint>& line,
                                                  const Driven& driven, const Taught& taught, std::size_t put_downs) {
  const Rider rider = rider_of(site, "r1", driven, kDayOfPutDowns);
  const auto ride = Ride::make(rider);
  if (!ride) return fail(ride.error());
  if (const Result<void> signs = (*ride)->learn_signs(taught.map); !signs) return fail(signs.error());
  std::vector<PutDown> all;
  for (std::size_t i = 0; i < put_downs; ++i) {
    Random random = Random(driven.seed).fork(kPutDownsOfSeed + i);
    (*ride)->body().put(beside_line(line, i % 2 == 1, random), {});
    const auto put_down = look(**ride, rider, taught);
    if (!put_down) return fail(put_down.error());
    if (!*put_down) return std::optional<Measured>();
    all.push_back(**put_down);
  }
  const Result<Moments> moments = (*ride)->finish();
  if (!moments) return fail(moments.error());
  double found = 0.0;
  double wrong = 0.0;
  std::vector<double> found_s;
  for (const PutDown& one : all) {
    if (!one.believes_at) continue;
    const Moment& then = (*moments)[*one.believes_at];
    if (then.believed &&
        is_believed_right(*then.believed, then.site_from_robot, taught.site_from_place, kRightM, kRightRad)) {
      found += 1.0;
      found_s.push_back(one.looked_s);
    } else {
      wrong += 1.0;
    }
  }
  Measured measured;
  measured.score.values = {{"put_downs", static_cast<double>(all.size())},
                           {"found", found},
                           {"found_percent", percent_of(found, static_cast<double>(all.size()))},
                           {"wrong", wrong},
                           {"found_median_s", quantile(found_s, 0.5)}};
  return std::optional(std::move(measured));
}

}  // namespace weft::evaluate::topometric
