#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/control/grid/costmap.hpp"
#include "agents/methods/method.hpp"
#include "agents/methods/open_odometry.hpp"
#include "agents/methods/topometric/belief.hpp"
#include "agents/methods/topometric/chart.hpp"
#include "agents/methods/topometric/config.hpp"
#include "agents/methods/topometric/content.hpp"
#include "agents/methods/topometric/plan.hpp"
#include "agents/methods/topometric/steer_config.hpp"
#include "agents/perception/clouds/cloud_window.hpp"
#include "agents/perception/rig.hpp"
#include "agents/perception/scan.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Navigates by a stereo pair that looks ahead (Dayoub, Morris, Upcroft & Corke 2013): clouds on the places of a
/// topological map, occupancy grids made of them where they are needed, a particle filter on a scan, and steering
/// through what is known to be free. A value: calibration and settings, fixed after construction; every call is pure.
class Topometric {
 public:
  static constexpr std::string_view name = "topometric";
  static constexpr std::uint32_t content_format = topometric_content_format;
  static constexpr bool contents_are_clouds = true;
  static constexpr SensorNeed needs = {SensorKind::stereo, Gaze::ahead, 1};
  /// Stereo odometry is off by a hundredth of the way at most, and a robot that comes back along a way sees much that
  /// nobody has seen: it goes farther without a fix than others.
  static constexpr std::string_view navigation_defaults =
      "[teach]\nspacing_m = 0.5\nspacing_rad = 0.35\n"
      "[follow]\nsegment_m = 5.0\nsure_m = 1.0\nblind_limit_m = 8.0\n";
  /// Its fixes are what odometry and scans say together.
  static constexpr bool is_posterior = true;
  /// It looks at free space, not at what a taught view showed: edges are driven in either direction.
  static constexpr bool drives_both_ways = true;

  /// Is kept between samples.
  struct Odometry {
    OpenOdometry::State open;
    Pose3 odometry_from_robot;          ///< since it began
    std::optional<CloudWindow> window;  ///< none before the first view
    std::optional<Costmap> costmap;     ///< in the plane of odometry_from_robot; none before the first view
    std::optional<Scan> scan;           ///< of the newest view; none: it showed nothing
    Pose3 level_from_robot;             ///< by the newest view that showed the floor
    double blind_m = 0.0;               ///< driven since a view was seen
    bool has_seen = false;              ///< the newest view was seen, and shows what stands there
    SensorTime time{};                  ///< of the newest sample, from the first on
    PlanState plan;                     ///< of steering and recovering
    SteerMemory steering;               ///< what was steered last
  };
  using Config = TopometricConfig;
  using Content = TopometricContent;
  static TopometricConfig read_config(const config::Table& table) { return read_topometric_config(table); }
  static std::optional<Signature> sign_bytes(ByteView bytes);

  /// invalid: a setting or the calibration breaks its bound; every one is named.
  static Result<Topometric> make(const TopometricConfig& config, const Rig& rig);

  Step observe(Odometry& odometry, const View* view, const Motion& motion) const;
  OrRefusal<Content> extract(const Odometry& odometry, const View& view) const;
  Bytes encode(const Content& content) const { return encode_topometric_content(content); }
  Result<Content> decode(ByteView bytes) const { return decode_topometric_content(bytes); }
  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const;
  std::optional<Signature> sign(const Content& content) const;
  /// Returns the relation of two places taught one after the other: odometry's, made better by what both saw.
  Relation registered(const Content& a, const Content& b, const Relation& a_from_b) const;
  double contradiction(const Content& a, const Content& b, const Relation& a_from_b) const;

  using Chart = TopometricChart;
  using Belief = TopometricBelief;
  static constexpr ChartSize chart_size = {12, 200};
  Chart chart(const std::vector<ChartPlace<Content>>& around) const;
  Belief begin(const Chart& chart, const Estimate& seed) const;
  Belief carried(const Chart& chart, const Estimate& seed, const Belief& before) const;
  Belief believed(const Chart& chart, const Belief& before, const Estimate& estimate) const;
  Located<Belief> locate(const Chart& chart, Belief belief, const Step& step, const Content& seen) const;

  Steering steer(Odometry& odometry, const Around<Topometric>* around, const Ahead& ahead) const;
  std::optional<Twist> recover(Odometry& odometry, const LostFor& lost) const;
  bool is_clear(const Chart& chart, const Pose2& centre_from_a, const Pose2& a_from_b) const;

  enum Condition : std::size_t { as_is, half_light };
  static constexpr std::array<std::string_view, 2> conditions = {"as_is", "half_light"};
  /// Is that of a robot which has driven blind for a metre or two.
  static constexpr GuessError revisit_guess = {0.15, 0.05};
  /// Returns what another robot sees of that view: one frame, none of those that a place is made of, on a day up to
  /// 30 % darker, or in half that light. Refusals: those of `extract` and of match_disparity.
  OrRefusal<Revisited<Content>> simulate_revisit(const Odometry& odometry, const View& view,
                                                 const Revisit& revisit) const;

  const TopometricConfig& config() const { return config_; }
  const StereoRig& rig() const { return odometry_.stereo().rectifier().rig(); }

 private:
  Topometric(const TopometricConfig& config, OpenOdometry odometry);
  OrRefusal<const StereoPair*> pair_to_store(const Odometry& odometry, const View& view) const;
  OrRefusal<Content> made_of(const CloudWindow& window, const Odometry& odometry, const StereoPair& pair) const;
  DepthNoise depth_noise() const { return {rig().focal_px, rig().baseline_m, config_.sight.disparity_sigma_px}; }

  TopometricConfig config_;
  OpenOdometry odometry_;
};

}  // namespace weft::agents
