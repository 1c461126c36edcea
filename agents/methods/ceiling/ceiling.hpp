#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "agents/methods/ceiling/chart.hpp"
#include "agents/methods/ceiling/common_errors.hpp"
#include "agents/methods/ceiling/config.hpp"
#include "agents/methods/ceiling/content.hpp"
#include "agents/methods/ceiling/height.hpp"
#include "agents/methods/ceiling/refinement.hpp"
#include "agents/methods/method.hpp"
#include "agents/perception/birds_eye.hpp"
#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/mount.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/plane/sign.hpp"
#include "agents/perception/rig.hpp"
#include "agents/perception/rocking_centre.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Navigates by the ceiling as one upward camera sees it (Lucas et al., as corrected): not by the centre of the image
/// but by the point above the robot, through mount and sway; not by one plane but by corners each at its own height.
/// A value: calibration and settings, fixed after construction; every call is pure.
class Ceiling {
 public:
  static constexpr std::string_view name = "ceiling";
  static constexpr std::uint32_t content_format = ceiling_content_format;

  /// Describes a corner that is followed. Its height is kept from keyframe to keyframe.
  struct Tracked {
    Eigen::Vector2d in_keyframe = Eigen::Vector2d::Zero();  ///< undistorted, normalised
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();        ///< in the newest view
    Eigen::Matrix2d counts = Eigen::Matrix2d::Identity();   ///< as a PlanePair says
    ToldHeight told = {};                                   ///< by keyframes that have ended
    ToldHeight tells = {};                                  ///< by the newest view against the keyframe
  };

  /// Names the means by which a view's motion was found, in the order in which they are tried.
  enum class SeenBy { nothing, corners, grey_values, features };
  static std::string_view name_of(SeenBy by);

  /// Is kept between samples. Motion is measured against a keyframe some frames back: standing still adds no drift.
  struct Odometry {
    TrackingImage newest;  ///< none: nothing has been seen since vision went blind
    Image keyframe_view;
    std::vector<Tracked> tracks;
    std::size_t keyframe_tracks = 0;  ///< when the keyframe was made
    Pose2 keyframe_from_robot;        ///< at the newest sample, rocking about the floor
    Attitude keyframe_attitude;
    Eigen::Matrix3d keyframe_told = Eigen::Matrix3d::Zero();        ///< information on its attitude by earlier fits
    Eigen::Vector3d keyframe_pull = Eigen::Vector3d::Zero();        ///< and its product with the mean
    Eigen::Matrix3d keyframe_covariance = Eigen::Matrix3d::Zero();  ///< of keyframe_from_robot, as steps have said
    Attitude attitude;                                              ///< at the newest view
    Eigen::Matrix3d attitude_covariance = Eigen::Matrix3d::Identity();
    std::uint64_t frame = 0;                      ///< of the newest view
    std::size_t inliers = 0;                      ///< of the newest view's motion
    bool followed = false;                        ///< the newest view's motion was seen
    SeenBy seen_by = SeenBy::nothing;             ///< likewise
    std::array<std::uint64_t, 4> views_by{};      ///< so many views each, by SeenBy
    std::optional<Pose2> wheels = Pose2{};        ///< since the keyframe; none: not reported all the way
    std::optional<PlaneViews> ended;              ///< the keyframe that ended with the newest view, and that view
    std::optional<RockingCentre> rocking_centre;  ///< none before the first view
    std::optional<MountWatch> mount;              ///< none before the first view
    std::optional<CeilingScale> scale_by_wheels;  ///< where no height is stated; none: not driven far enough
    double wheels_m = 0.0;                        ///< driven by wheels over keyframes that have ended, and...
    double seen_m = 0.0;                          ///< ...what was seen of the same, as if at the supposed height
    std::optional<BirdsEye> birds_eye;            ///< of the ceiling as wheels have told it
  };
  using Config = CeilingConfig;
  static constexpr SensorNeed needs = {SensorKind::camera, Gaze::up, 1};
  /// Places lie farther apart than on a floor: a ceiling is far away. A robot that looks for itself stands and takes
  /// two images a second: it tries with one image all places that are proposed to it, which takes 45 ms at most.
  static constexpr std::string_view navigation_defaults =
      "[teach]\nspacing_m = 0.4\nspacing_rad = 0.5\n[locate]\nseek_tries = 64\n";
  static CeilingConfig read_config(const config::Table& table) { return read_ceiling_config(table); }
  /// Returns what `sign` gives, of a content's bytes; none: they are no content, or give no signature.
  static std::optional<Signature> sign_bytes(ByteView bytes) {
    const Result<CeilingContent> content = decode_ceiling_content(bytes);
    return content ? sign_features(content->features) : std::nullopt;
  }
  /// Returns the patch of a content's bytes, for people. corrupt, newer: as decode_ceiling_content.
  static Result<PlanePatch> patch_of_bytes(ByteView bytes) {
    Result<CeilingContent> content = decode_ceiling_content(bytes);
    if (!content) return fail(content.error());
    return std::move(content->patch);
  }
  using Content = CeilingContent;

  /// Makes a method of settings and a camera. invalid: a setting or the calibration breaks its bound, or the camera
  /// does not look up at the ceiling; every one is named.
  static Result<Ceiling> make(const CeilingConfig& config, const CameraModel& camera);
  static Result<Ceiling> make(const CeilingConfig& config, const Rig& rig) { return make(config, rig.camera()); }

  /// Returns the motion as Metric2. Blind reasons: first_view, dropped_frame, not_an_image, wrong_size, low_contrast,
  /// few_tracks, not_converged, disagrees_with_wheels, disagrees_with_command; scale_unknown: no height is stated and
  /// wheels have not told it yet.
  Step observe(Odometry& odometry, const View* view, const Motion& motion) const;

  static constexpr std::array<WatchedDiagnostic, 0> watched = {};
  /// Returns what driving has shown of the mount against its calibration, mount_pitch_rad and mount_roll_rad, and
  /// ceiling_height_share, the stated height's error as a share of the distance, which wheels show; none: not driven
  /// far enough.
  std::vector<Diagnostic> diagnose(const Odometry& odometry) const;

  /// Says how to expose the next view: what is no lamp to mid grey. None: nobody knows how this one was exposed.
  std::optional<Exposure> expose(const Odometry& odometry, const View& view) const;

  /// Extracts what a place here would store. Refusals: not_an_image, wrong_size, scale_unknown, too_blank (features).
  OrRefusal<Content> extract(const Odometry& odometry, const View& view) const;

  Bytes encode(const Content& content) const { return encode_ceiling_content(content); }
  Result<Content> decode(ByteView bytes) const { return decode_ceiling_content(bytes); }

  /// Returns Metric2 a_from_b of the robots' level frames. With a guess, matching is guided by it; without, every
  /// heading and offset is possible. Refusals: other_ceiling (heights), no_overlap, few_matches, no_consensus,
  /// few_inliers, few_inliers_share, not_rigid, little_overlap, little_spread, large_residual, disagrees_with_guess;
  /// ambiguous: what both see looks nearly as well like another stretch of a, as on a grid of lamps; or, without a
  /// guess, nothing agrees because most corners of a and of b have a twin in their own view.
  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const;

  using Chart = CeilingChart;
  struct Belief {
    Metric2 centre_from_robot;  ///< of the chart's centre; its covariance leaves out how places lie to one another
  };
  static constexpr ChartSize chart_size = {12, 200};
  Chart chart(const std::vector<ChartPlace<Content>>& around) const;
  Belief begin(const Chart& chart, const Estimate& seed) const;
  Belief believed(const Chart& chart, const Belief& before, const Estimate& estimate) const;
  /// Relates a view to the mosaic about where the robot is believed to be, as the nearest place would have seen it
  /// (Lucas et al., III, where the image is found in the mosaic of images); where that is refused, to that place
  /// itself. Refusals: nothing_near, and those of `relate`.
  Located<Belief> locate(const Chart& chart, Belief belief, const Step& step, const Content& seen) const;

  using Refinement = CeilingRefinement;
  /// Begins to adjust a taught run as a mosaic of what hangs above it (Lucas et al., II.D, where frames were laid on
  /// one another). No pieces: `is_adjustable` says no, or nothing binds the run better than odometry does.
  Refinement begin_refine(const CeilingRun& run) const;
  bool refine(Refinement& refinement) const;
  std::size_t pieces(const Refinement& refinement) const;
  Amendments<Content> refined(Refinement refinement) const;

  /// Returns the middle of the features, in the robot's frame.
  Eigen::Vector2d gaze(const Content& content) const;
  std::optional<Signature> sign(const Content& content) const { return sign_features(content.features); }

  /// Returns the ceiling's height: as stated, or as wheels have told it; none: neither.
  std::optional<CeilingScale> scale(const Odometry& odometry) const;

  const CameraModel& camera() const { return camera_; }
  const CeilingConfig& config() const { return config_; }

 private:
  Ceiling(const CeilingConfig& config, const CameraModel& camera);

  /// Returns the height that odometry works with: a supposed one as long as none is known.
  double working_height_m(const Odometry& odometry) const;

  CeilingConfig config_;
  CameraModel camera_;
  std::optional<BirdsEye> birds_eye_;  ///< of the ceiling at its stated height
};

}  // namespace weft::agents
