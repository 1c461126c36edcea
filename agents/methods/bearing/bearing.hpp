#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/methods/bearing/config.hpp"
#include "agents/methods/bearing/content.hpp"
#include "agents/methods/bearing/other_cameras.hpp"
#include "agents/methods/method.hpp"
#include "agents/perception/rig.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Navigates by one camera that looks ahead and whose lens nobody has measured (Krajnik et al., "Navigation without
/// localisation", 2018, as corrected in docs/decisions/026-bearing-as-corrected.md): finds how far the robot has
/// travelled along a path that it was taught, and by how much it is turned against it, but never a pose. A value;
/// every call is pure.
class Bearing {
 public:
  static constexpr std::string_view name = "bearing";
  static constexpr std::uint32_t content_format = bearing_content_format;
  static constexpr std::uint32_t learned_format = bearing_learned_format;
  using Content = BearingContent;

  struct Odometry {
    Twist driving;  ///< as wheels or command say, at the newest sample
  };

  /// Describes a place along the path around the chart's centre.
  struct Stop {
    PlaceId place;
    AlongPath centre_from_place;
    std::shared_ptr<const Content> content;  ///< null while its bytes have not arrived
  };
  /// Holds the places around, sorted by their distance from the centre along the path (signed).
  struct Chart {
    std::vector<Stop> stops;
  };
  struct Belief {
    AlongPath centre_from_robot;
    OtherCameras cameras = {};  ///< that taught
    // Of one of them, by the newest view; both count once its fix is believed.
    std::optional<CameraLook> look = {};
    std::optional<CameraRise> rise = {};
  };

  /// Makes a method. invalid: a setting or the camera's focal length breaks its bound; every one is named.
  static Result<Bearing> make(const BearingConfig& config, const CameraModel& camera);
  static Result<Bearing> make(const BearingConfig& config, const Rig& rig) { return make(config, rig.camera()); }
  using Config = BearingConfig;
  static constexpr ChartSize chart_size = {12, 200};
  static constexpr SensorNeed needs = {SensorKind::camera, Gaze::ahead, 1};
  static BearingConfig read_config(const config::Table& table) { return read_bearing_config(table); }

  /// Returns an AlongPath, by wheels or, without, by the command. Blind reasons: no_view, not_an_image, wrong_size.
  Step observe(Odometry& odometry, const View* view, const Motion& motion) const;

  /// Returns the exposure to wish for. None: the view's own is not known, or it is no image of the camera.
  std::optional<Exposure> expose(const Odometry& odometry, const View& view) const;

  /// Extracts what a place here would store. Refusals: not_an_image, wrong_size, few_features.
  OrRefusal<Content> extract(const Odometry& odometry, const View& view) const;

  Bytes encode(const Content& content) const { return encode_bearing_content(content); }
  Result<Content> decode(ByteView bytes) const { return decode_bearing_content(bytes); }

  /// Returns an AlongPath: the heading on which most of what both see agrees, the distance of the guess (0 without),
  /// with its uncertainty. Without a guess more evidence is required. Refusals: few_features, no_majority, ambiguous,
  /// further_off, another_scene, described_otherwise.
  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const;

  /// Returns how many features stand in both as in views of one scene (BearingConfig::inlier_px); 0: they tell no
  /// heading.
  double likeness(const Content& a, const Content& b) const;
  double most_of_rival(double likeness) const;

  /// Returns how the robot was driving at the place (the velocity profile, III-B).
  static Twist driven(const Content& content) { return content.driving; }

  /// Returns none: corners that look alike are everywhere.
  std::optional<Signature> sign(const Content&) const { return std::nullopt; }

  Chart chart(const std::vector<ChartPlace<Content>>& around) const;
  Belief begin(const Chart& chart, const Estimate& seed) const;
  /// Begins anew but keeps what `before` has found out about the cameras that taught: they are still the same.
  Belief begin(const Chart& chart, const Estimate& seed, const Belief& before) const;
  /// Finds the robot's distance along the path and its heading. The distance follows from the looming against each of
  /// the places before and behind, corrected for the focal lengths of the cameras that taught them, which are
  /// estimated on the way (other_cameras.hpp). The heading is the one that most of these places agree on. Refusals:
  /// nothing_near, headings_differ, and those of `relate` when none of them tells a heading.
  Located<Belief> locate(const Chart& chart, Belief belief, const Step& step, const Content& seen) const;

  /// Returns the belief once navigation has weighed the last fix: the position is that of `estimate`; what the view
  /// told of the cameras that taught counts from now on.
  Belief believed(const Chart& chart, const Belief& before, const Estimate& estimate) const;

  /// Returns the features of the place with one more pass counted, without those that are hardly ever seen and with
  /// some of the view's that the place does not have, put where what both show places them (learn.cpp). None: the
  /// view is described otherwise or of another focal length, was taken too far before, behind or beside the place, or
  /// its heading is not sure.
  std::optional<Content> learn(const Content& known, const Content& seen, const Relation& known_from_seen) const;
  /// Returns whether a robot that comes by sees so much more of `learned` (BearingLearnConfig::worth; worth.cpp).
  bool is_worth_sharing(const Content& shared, const Content& learned) const;

  const BearingConfig& config() const { return config_; }

 private:
  Bearing(const BearingConfig& config, const CameraModel& camera) : config_(config), camera_(camera) {}

  BearingConfig config_;
  CameraModel camera_;
};

}  // namespace weft::agents
