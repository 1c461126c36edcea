#include "agents/navigation/config.hpp"

#include <string>

namespace weft::agents {

namespace {

enum class Low : std::uint8_t { open, closed };

class Bounds {
 public:
  void operator()(const char* field, double value, Low kind, double low, double high) {
    if (value <= high && (value > low || (kind == Low::closed && value == low))) return;
    issues.push_back({ErrorCode::invalid, std::string("navigation: ") + field + " is " + std::to_string(value) +
                                              "; it must be in " + (kind == Low::closed ? "[" : "(") +
                                              std::to_string(low) + ", " + std::to_string(high) + "]"});
  }
  std::vector<Error> issues;
};

void check_teach(const TeachConfig& teach, Bounds& in) {
  in("teach.spacing_m", teach.spacing_m, Low::open, 0, 2);
  in("teach.spacing_rad", teach.spacing_rad, Low::open, 0, 1.5);
  in("teach.last_place_m", teach.last_place_m, Low::open, 0, 1);
}

void check_belief(const BeliefConfig& belief, Bounds& in) {
  in("belief.odometry_share_m", belief.odometry_share_m, Low::closed, 0, 1);
  in("belief.odometry_share_rad", belief.odometry_share_rad, Low::closed, 0, 1);
  in("belief.map_sigma_m", belief.map_sigma_m, Low::closed, 0, 0.2);
  in("belief.map_sigma_rad", belief.map_sigma_rad, Low::closed, 0, 0.2);
  in("belief.gate_sigmas", belief.gate_sigmas, Low::open, 0, 10);
  in("belief.gate_floor_m", belief.gate_floor_m, Low::open, 0, 0.5);
  in("belief.gate_floor_rad", belief.gate_floor_rad, Low::open, 0, 0.5);
  in("belief.unseeded_fixes", belief.unseeded_fixes, Low::closed, 1, 10);
  in("belief.overrule_fixes", belief.overrule_fixes, Low::closed, 2, 20);
}

void check_locate(const LocateConfig& locate, Bounds& in) {
  in("locate.every_m", locate.every_m, Low::open, 0, 2);
  in("locate.every_rad", locate.every_rad, Low::open, 0, 1.5);
  in("locate.standing_samples", locate.standing_samples, Low::closed, 1, 1000);
  in("locate.tries", locate.tries, Low::closed, 1, 50);
  in("locate.reach_m", locate.reach_m, Low::open, 0, 10);
  in("locate.reach_share", locate.reach_share, Low::closed, 0, 2);
  in("locate.route_preference", locate.route_preference, Low::open, 0, 1);
  in("locate.near_hops", locate.near_hops, Low::closed, 1, 100);
  in("locate.most_hops", locate.most_hops, Low::closed, 1, 1000);
  in("locate.seed_hops", locate.seed_hops, Low::closed, 0, 1000);
  in("locate.seek_tries", locate.seek_tries, Low::closed, 1, 1000);
  in("locate.seek_signs", locate.seek_signs, Low::closed, 1, 10000);
  in("locate.decoded_contents", locate.decoded_contents, Low::closed, 16, 100000);
}

void check_stitch(const StitchConfig& stitch, Bounds& in) {
  in("stitch.most_a_place", stitch.most_a_place, Low::closed, 1, 8);
  in("stitch.tries", stitch.tries, Low::closed, 1, 20);
  in("stitch.own_distance_m", stitch.own_distance_m, Low::closed, 1, 1000);
  in("stitch.reach_m", stitch.reach_m, Low::open, 0, 3);
  in("stitch.most_reach_m", stitch.most_reach_m, Low::open, 0, 10);
  in("stitch.agree_m", stitch.agree_m, Low::open, 0, 0.5);
  in("stitch.agree_rad", stitch.agree_rad, Low::open, 0, 0.5);
  in("stitch.trusted_sigma_m", stitch.trusted_sigma_m, Low::open, 0, 1);
  in("stitch.drivable_m", stitch.drivable_m, Low::open, 0, 3);
  in("stitch.drivable_rad", stitch.drivable_rad, Low::open, 0, 3.2);
  in("stitch.merge_m", stitch.merge_m, Low::open, 0, 10);
}

void check_follow(const FollowConfig& follow, Bounds& in) {
  in("follow.speed_m_s", follow.speed_m_s, Low::open, 0, 2);
  in("follow.segment_m", follow.segment_m, Low::closed, 0.5, 20);
  in("follow.footprint_radius_m", follow.footprint_radius_m, Low::open, 0, 5);
  in("follow.join_m", follow.join_m, Low::open, 0, 5);
  in("follow.give_up_s", follow.give_up_s, Low::open, 0, 600);
  in("follow.blind_limit_m", follow.blind_limit_m, Low::open, 0, 20);
  in("follow.arrive_m", follow.arrive_m, Low::open, 0, 0.5);
  in("follow.arrive_rad", follow.arrive_rad, Low::open, 0, 0.5);
  in("follow.stop_short_m", follow.stop_short_m, Low::closed, 0, 0.5);
  in("follow.settle_samples", follow.settle_samples, Low::closed, 0, 1000);
}

}  // namespace

std::vector<Error> check(const NavigationConfig& config) {
  Bounds in;
  check_teach(config.teach, in);
  check_belief(config.belief, in);
  check_locate(config.locate, in);
  check_stitch(config.stitch, in);
  check_follow(config.follow, in);
  std::vector<Error> issues = check(config.tracker);
  issues.insert(issues.end(), in.issues.begin(), in.issues.end());
  return issues;
}

}  // namespace weft::agents
