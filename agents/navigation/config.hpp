#pragma once
#include <cstdint>
#include <vector>

#include "agents/control/tracker.hpp"
#include "core/config/config.hpp"
#include "core/result.hpp"

namespace weft::agents {

struct TeachConfig {
  double spacing_m = 0.2;      ///< xi_t (Gadd & Newman III-B): a place is kept after this travel; (0, 2]
  double spacing_rad = 0.13;   ///< xi_R: or after this turn; (0, 1.5]
  double last_place_m = 0.03;  ///< the end is kept as a place when it lies farther from the last than this; (0, 1]
};

struct BeliefConfig {
  bool in_plane = false;             ///< fixes are gated by their planar readings alone, whatever else they say
  double map_sigma_m = 0.005;        ///< sigma added for an edge between two places; [0, 0.2]
  double map_sigma_rad = 0.005;      ///< [0, 0.2]
  double gate_sigmas = 4.0;          ///< a fix this far from what was predicted is refused (Mahalanobis); (0, 10]
  double gate_floor_m = 0.03;        ///< sigma that a disagreement always has; (0, 0.5]
  double gate_floor_rad = 0.03;      ///< (0, 0.5]
  std::uint32_t unseeded_fixes = 2;  ///< that must agree before an unseeded robot believes where it is; [1, 10]
  std::uint32_t overrule_fixes = 4;  ///< that must agree with one another to overrule the prediction; [2, 20]
  bool fuse = true;                  ///< weigh fix and prediction by covariance; else a fix counts alone
};

struct LocateConfig {
  double every_m = 0.1;                 ///< localise after this travel; (0, 2]
  double every_rad = 0.15;              ///< or this turn; (0, 1.5]
  std::uint32_t standing_samples = 10;  ///< or after this many samples; [1, 1000]
  std::uint32_t tries = 3;              ///< candidates related an attempt; [1, 50]
  double reach_m = 1.0;                 ///< candidates predicted farther away (norm) are left alone; (0, 10]
  double reach_share = 0.3;             ///< added to the reach for each metre travelled blind; [0, 2]
  double route_preference = 0.6;        ///< factor on the predicted norm of places on the route; (0, 1]
  std::uint32_t near_hops = 6;          ///< depth of the search after a recent fix; [1, 100]
  std::uint32_t most_hops = 25;         ///< d_max: the depth grows to this while blind; [1, 1000]
  std::uint32_t seed_hops = 20;         ///< sigma: chain around a seed that is tried; [0, 1000]
  std::uint32_t seek_tries = 12;        ///< places related per sample while seeking; [1, 1000]
  std::uint32_t seek_signs = 64;        ///< contents read for their signature per sample while seeking; [1, 10000]
  double rival_m = 5.0;  ///< along the way from where an unseeded robot seems to stand; what is nearer may look like
                         ///< it, but not more; (0, 10]
  std::uint32_t decoded_mb = 256;  ///< of contents, as they are encoded, kept decoded; [1, 65536]
};

struct StitchConfig {
  bool enabled = true;
  std::uint32_t most_a_place = 2;  ///< [1, 8]
  std::uint32_t tries = 3;         ///< contents related for each kept place; [1, 20]
  double own_distance_m = 5.0;     ///< places of one's own experience count when driven this far ago; [1, 1000]
  double reach_m = 0.5;            ///< predicted norm up to which contents are compared; (0, 3]
  double most_reach_m = 2.5;       ///< the reach grows with the prediction's uncertainty up to this; (0, 10]
  double agree_m = 0.08;           ///< predicted and related must agree within this; (0, 0.5]
  double agree_rad = 0.06;         ///< (0, 0.5]
  double trusted_sigma_m = 0.08;   ///< a prediction less certain needs a second stitch that agrees; (0, 1]
  double most_doubt = 0.05;  ///< without a guess: what may speak against a relation, e.g. what has changed; [0, 1]
  double proven_m = 60.0;    ///< driven beside other runs, uncontradicted: their stitches are handed in at once; on a
                             ///< shorter way they wait until it has parted, or the run ends; (0, 1000]
  double parted_m = 10.0;    ///< driven with no place of other runs within reach: the way has parted; (0, 100]
  double most_contradiction = 8.0;  ///< parts of views, summed up, that may speak against another run; [0, 1000]
  double most_contradiction_of_a_place = 8.0;  ///< so much one place adds at most: several have to agree; (0, 1000]
  double sure_m = 0.2;          ///< sigma along a path that a stitch may have which knows no pose; (0, 1]
  double drivable_m = 0.6;      ///< places farther apart cannot be driven across; (0, 3]
  double drivable_rad = 0.5;    ///< headings that differ by more than this cannot be driven across; (0, 3.2]
  double across_every_m = 0.6;  ///< way from one stitch to a lane met head-on or across to the next; (0, 10]
  double merge_m = 2.0;         ///< a change over to the other place's way takes no longer than this; (0, 10]
};

struct FollowConfig {
  double speed_m_s = 0.6;           ///< (0, 2]
  double segment_m = 3.0;           ///< theta: only this much of the route is laid out ahead; [0.5, 20]
  double footprint_radius_m = 0.4;  ///< (0, 5]
  double join_m = 1.0;              ///< a route farther away than this is not joined; (0, 5]
  double blind_limit_m = 1.5;       ///< travelled without a fix: lost, stop; (0, 20]
  double sure_m = 0.4;              ///< travelled without a fix: it begins to slow down; [0, 20], below blind_limit_m
  double sure_sigma_m = 0.05;       ///< of its position; less sure, it drives slower in proportion; (0, 1]
  double unsure_share = 0.35;       ///< of its speed, that it keeps until it is lost; (0, 1]
  double arrive_m = 0.03;           ///< distance to the goal that is good enough; (0, 0.5]
  double arrive_rad = 0.0175;       ///< (0, 0.5]
  double aside_m = 1.0;             ///< a method that steers itself leaves its route by no more; [0, 3]
  double stop_short_m = 0.02;       ///< before a released point that is not the goal; [0, 0.5]
  double give_up_s = 30.0;          ///< standing where its route cannot be driven from; (0, 600]
  std::uint32_t settle_samples = 30;  ///< to wait for a fix at the goal before going by what is believed; [0, 1000]
};

struct LearnConfig {
  bool enabled = true;  ///< places that the robot drives by are learned from what it sees
  std::uint32_t places =
      2048;             ///< that it keeps what it has learned of, the least recently passed forgotten; [16, 100000]
  double sure_m = 0.5;  ///< travelled since the fix before: a view that has shown less is not learned from; (0, 5]
};

/// Holds all settings of teach, localise, follow. Checked once, fixed afterwards.
struct NavigationConfig {
  TeachConfig teach;
  BeliefConfig belief;
  LocateConfig locate;
  StitchConfig stitch;
  FollowConfig follow;
  LearnConfig learn;
  TrackerConfig tracker;
};

/// Returns every bound that does not hold, each naming field, value and bound.
std::vector<Error> check(const NavigationConfig& config);

/// Reads a table of parts: [teach], [belief], [locate], [stitch], [follow], [learn], [control], [control.steering],
/// [control.speed], each with the settings above by their names, but for footprint_radius_m, which others need too.
/// The table collects what is wrong.
NavigationConfig read_navigation_config(const config::Table& table, const NavigationConfig& defaults);

}  // namespace weft::agents
