#include "agents/navigation/config.hpp"

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include "agents/control/settings.hpp"

namespace weft::agents {

namespace {

// One list for `check` and for the reader; the header says the same beside each setting.
template <class Config, class In>
void each_teach(Config& teach, const In& in) {
  in("spacing_m", teach.spacing_m, Low::open, 0, 2);
  in("spacing_rad", teach.spacing_rad, Low::open, 0, 1.5);
  in("last_place_m", teach.last_place_m, Low::open, 0, 1);
}

template <class Config, class In>
void each_belief(Config& belief, const In& in) {
  in("map_sigma_m", belief.map_sigma_m, Low::closed, 0, 0.2);
  in("map_sigma_rad", belief.map_sigma_rad, Low::closed, 0, 0.2);
  in("gate_sigmas", belief.gate_sigmas, Low::open, 0, 10);
  in("gate_floor_m", belief.gate_floor_m, Low::open, 0, 0.5);
  in("gate_floor_rad", belief.gate_floor_rad, Low::open, 0, 0.5);
  in("unseeded_fixes", belief.unseeded_fixes, Low::closed, 1, 10);
  in("overrule_fixes", belief.overrule_fixes, Low::closed, 2, 20);
  in("fuse", belief.fuse, Low::closed, 0, 1);
  in("in_plane", belief.in_plane, Low::closed, 0, 1);
}

template <class Config, class In>
void each_locate(Config& locate, const In& in) {
  in("every_m", locate.every_m, Low::open, 0, 2);
  in("every_rad", locate.every_rad, Low::open, 0, 1.5);
  in("standing_samples", locate.standing_samples, Low::closed, 1, 1000);
  in("tries", locate.tries, Low::closed, 1, 50);
  in("reach_m", locate.reach_m, Low::open, 0, 10);
  in("reach_share", locate.reach_share, Low::closed, 0, 2);
  in("route_preference", locate.route_preference, Low::open, 0, 1);
  in("near_hops", locate.near_hops, Low::closed, 1, 100);
  in("most_hops", locate.most_hops, Low::closed, 1, 1000);
  in("seed_hops", locate.seed_hops, Low::closed, 0, 1000);
  in("seek_tries", locate.seek_tries, Low::closed, 1, 1000);
  in("seek_signs", locate.seek_signs, Low::closed, 1, 10000);
  in("rival_m", locate.rival_m, Low::open, 0, 10);
  in("decoded_mb", locate.decoded_mb, Low::closed, 1, 65536);
}

template <class Config, class In>
void each_stitch(Config& stitch, const In& in) {
  in("enabled", stitch.enabled, Low::closed, 0, 1);
  in("most_a_place", stitch.most_a_place, Low::closed, 1, 8);
  in("tries", stitch.tries, Low::closed, 1, 20);
  in("own_distance_m", stitch.own_distance_m, Low::closed, 1, 1000);
  in("reach_m", stitch.reach_m, Low::open, 0, 3);
  in("most_reach_m", stitch.most_reach_m, Low::open, 0, 10);
  in("agree_m", stitch.agree_m, Low::open, 0, 0.5);
  in("agree_rad", stitch.agree_rad, Low::open, 0, 0.5);
  in("trusted_sigma_m", stitch.trusted_sigma_m, Low::open, 0, 1);
  in("most_doubt", stitch.most_doubt, Low::closed, 0, 1);
  in("proven_m", stitch.proven_m, Low::open, 0, 1000);
  in("parted_m", stitch.parted_m, Low::open, 0, 100);
  in("most_contradiction", stitch.most_contradiction, Low::closed, 0, 1000);
  in("most_contradiction_of_a_place", stitch.most_contradiction_of_a_place, Low::open, 0, 1000);
  in("sure_m", stitch.sure_m, Low::open, 0, 1);
  in("drivable_m", stitch.drivable_m, Low::open, 0, 3);
  in("drivable_rad", stitch.drivable_rad, Low::open, 0, 3.2);
  in("across_every_m", stitch.across_every_m, Low::open, 0, 10);
  in("merge_m", stitch.merge_m, Low::open, 0, 10);
}

template <class Config, class In>
void each_follow(Config& follow, const In& in) {
  in("speed_m_s", follow.speed_m_s, Low::open, 0, 2);
  in("segment_m", follow.segment_m, Low::closed, 0.5, 20);
  in("join_m", follow.join_m, Low::open, 0, 5);
  in("give_up_s", follow.give_up_s, Low::open, 0, 600);
  in("blind_limit_m", follow.blind_limit_m, Low::open, 0, 20);
  in("sure_m", follow.sure_m, Low::closed, 0, 20);
  in("sure_sigma_m", follow.sure_sigma_m, Low::open, 0, 1);
  in("unsure_share", follow.unsure_share, Low::open, 0, 1);
  in("arrive_m", follow.arrive_m, Low::open, 0, 0.5);
  in("arrive_rad", follow.arrive_rad, Low::open, 0, 0.5);
  in("aside_m", follow.aside_m, Low::closed, 0, 3);
  in("stop_short_m", follow.stop_short_m, Low::closed, 0, 0.5);
  in("settle_samples", follow.settle_samples, Low::closed, 0, 1000);
}

template <class Config, class In>
void each_learn(Config& learn, const In& in) {
  in("enabled", learn.enabled, Low::closed, 0, 1);
  in("places", learn.places, Low::closed, 16, 100000);
  in("sure_m", learn.sure_m, Low::open, 0, 5);
}

/// Visits every setting but the controller's.
template <class Config, class Section>
void each_setting(Config& config, const Section& section) {
  each_teach(config.teach, section("teach"));
  each_belief(config.belief, section("belief"));
  each_locate(config.locate, section("locate"));
  each_stitch(config.stitch, section("stitch"));
  each_follow(config.follow, section("follow"));
  each_learn(config.learn, section("learn"));
}

/// Puts what the table says into a setting; the setting's own value is the default.
auto reader(const config::Table& table) {
  return [table](const char* name, auto& value, Low kind, double low, double high) {
    using Value = std::remove_reference_t<decltype(value)>;
    constexpr double above_open = 1e-6;
    if constexpr (std::is_same_v<Value, bool>) {
      value = table.boolean(name, value);
    } else if constexpr (std::is_integral_v<Value>) {
      value = static_cast<Value>(table.integer(name, value, std::llround(low), std::llround(high)));
    } else {
      value = table.number(name, value, kind == Low::open ? low + above_open : low, high);
    }
  };
}

}  // namespace

std::vector<Error> check(const NavigationConfig& config) {
  std::vector<Error> issues = check(config.tracker);
  OutOfBounds out("navigation");
  each_setting(config, [&](const char* part) { return out.section(part); });
  out.section("follow")("footprint_radius_m", config.follow.footprint_radius_m, Low::open, 0, 5);
  issues.insert(issues.end(), out.issues.begin(), out.issues.end());
  const FollowConfig& follow = config.follow;
  if (follow.sure_m >= follow.blind_limit_m) {
    issues.push_back({ErrorCode::invalid, "navigation: follow.sure_m is " + std::to_string(follow.sure_m) +
                                              "; it must be below follow.blind_limit_m, which is " +
                                              std::to_string(follow.blind_limit_m)});
  }
  return issues;
}

NavigationConfig read_navigation_config(const config::Table& table, const NavigationConfig& defaults) {
  NavigationConfig config = defaults;
  each_setting(config, [&](const char* part) { return reader(table.table(part)); });
  const config::Table control = table.table("control");
  each_control_setting(config.tracker,
                       [&](const std::string& part) { return reader(part.empty() ? control : control.table(part)); });
  return config;
}

}  // namespace weft::agents
