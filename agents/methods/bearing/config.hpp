#pragma once
#include <string>
#include <vector>

#include "agents/perception/exposure.hpp"
#include "agents/perception/heading_vote.hpp"
#include "agents/perception/upright_features.hpp"
#include "core/config/config.hpp"

namespace weft::agents {

/// Holds the settings for places that learn from the views of robots that come by (learn.cpp). Bounds in brackets.
struct BearingLearnConfig {
  double along_m = 0.07;        ///< [0.01, 0.5] a view taken so far before or behind the place is learned from
  double along_sigma_m = 0.05;  ///< [0.005, 1] as far as it is known where it was taken
  double above_chance = 10.0;   ///< [0, 50] as vote.above_chance: the heading is sure
  double heading_rad = 0.03;    ///< [0.001, 0.5] most between this heading and what all places around say
  double spread_rad = 0.02;   ///< [0.001, 0.2] most by which turns that single features show differ: taken from aside
  double moved_px = 8.0;      ///< [0.5, 50] a feature is seen where it is expected; across, for near and far
  double risen_px = 4.0;      ///< [0.5, 50] and in height
  int features = 450;         ///< [20, 2000] that a place has at most: what a vote costs grows with them
  int newcomers = 100;        ///< [0, 500] features that come in with a pass
  int few_passes = 6;         ///< [2, 100] a feature stays for so many, whatever becomes of it
  double hardly_ever = 0.15;  ///< [0, 1] share of its passes; seen less often, it goes
  double seldom = 0.33;       ///< [0, 1] seen less often, it makes room for newcomers
  int fade_passes = 24;       ///< [4, 255] counts are halved when there are more: old evidence fades
  double stays = 0.3;         ///< [0, 1] chance that what was new in one view is seen again
  double worth = 0.25;        ///< [0.01, 10] by which share more of a place is to be seen to be worth sharing it
};

/// Holds the settings of the method `bearing` (Krajnik et al. 2018). Bounds in brackets beside each setting; `check`
/// enforces them.
struct BearingConfig {
  // Views
  double focal_px = 386.0;  ///< [100, 2000]; images are brought to this focal length: what stands around a corner is
                            ///< to be seen alike by robots with other cameras
  int width_px = 320;       ///< [64, 4096] that a vote's shares of a width are of
  UprightConfig features{.count = 300, .cell_widths = 0.022};
  HeadingVoteConfig vote;
  ExposureConfig exposure;
  double vote_sigma_rad = 0.01;  ///< [1e-4, 0.2] of a heading told by one vote of many

  // Motion: distance travelled comes from wheels, or from what was commanded
  double wheel_distance_share = 0.06;    ///< [1e-3, 1] 1 sigma of the distance: alike in all steps
  double wheel_turn_rad_m = 0.08;        ///< [1e-3, 1] turned for each metre that nobody tells: alike in all steps
  double command_distance_share = 0.12;  ///< [1e-3, 1] the same without wheels to read
  double command_turn_rad_m = 0.12;      ///< [1e-3, 1]
  double slip_m = 0.02;                  ///< [1e-4, 0.5] 1 sigma of what the first metre adds, by itself
  double slip_rad = 0.03;                ///< [1e-4, 0.5] likewise of the heading

  // Where along the path: the neighbours before and behind vote too
  double neighbours_m = 0.65;    ///< [0, 3] places so far along the path are compared
  int most_neighbours = 7;       ///< [1, 21]
  double along_sigma_m = 0.012;  ///< [0.001, 2] of a distance told by how much nearer things are than there
  double focal_share = 0.01;     ///< [1e-4, 0.1] 1 sigma of what two data sheets' focal lengths are off by

  // Where nobody says where it is, every place may be it: one that is not looks alike by chance
  double anywhere_above_chance = 8.0;  ///< [0, 50] as vote.above_chance
  double anywhere_runner_up = 0.5;     ///< [0, 1] most of the next peak, over the winner's
  double anywhere_looming = 0.12;      ///< [0.01, 2] share of their distance by which things may be nearer or further
                                       ///< off: down an aisle a place looks like one that is metres on
  int anywhere_inliers = 36;           ///< [0, 1000] features at heights that one scene allows (scene_inliers.hpp);
                                       ///< other aisles with the same loads on one side show up to 35
  double inlier_px = 1.0;              ///< [0.1, 20] within so much
  double anywhere_rival = 0.6;         ///< [0, 1] most such features in a place elsewhere, over those of the place
  int anywhere_rival_inliers = 18;  ///< [0, 1000] and most of them at all: aisles that hold the same are told apart
                                    ///< by chance alone
  double unknown_along_sigma_m = 0.5;  ///< [0.05, 10] of a relation that tells the heading alone

  BearingLearnConfig learn;  ///< keys begin with learn_
};

/// Returns a line for every setting that breaks its bounds: name, value, bounds. Empty when all is well.
std::vector<std::string> check(const BearingConfig& config);
BearingConfig read_bearing_config(const config::Table& table);

}  // namespace weft::agents
