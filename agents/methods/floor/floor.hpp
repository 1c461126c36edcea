#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/methods/floor/calibration_errors.hpp"
#include "agents/methods/floor/config.hpp"
#include "agents/methods/floor/content.hpp"
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

/// Navigates by the floor's texture seen through one downward camera (Gadd & Newman, "A Framework for
/// Infrastructure-Free Warehouse Navigation", as corrected in docs/decisions/020-floor-as-corrected.md). A value:
/// calibration and settings, fixed after construction; every call is pure.
class Floor {
 public:
  static constexpr std::string_view name = "floor";
  static constexpr std::uint32_t content_format = floor_content_format;

  /// Describes a corner of the keyframe that is still followed.
  struct Tracked {
    Eigen::Vector2d in_keyframe = Eigen::Vector2d::Zero();  ///< undistorted, normalised
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();        ///< in the newest view
    Eigen::Matrix2d counts = Eigen::Matrix2d::Identity();   ///< as a PlanePair says
  };

  /// Names the means by which a view's motion was found. Corners are the fastest and the most exact; where they fail
  /// (too few of them, or not on one plane), grey values are aligned, then features matched, before vision is blind.
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
    /// Hold the information on the keyframe's attitude that earlier fits gave, beyond what is known of every view,
    /// and its product with the mean.
    Eigen::Matrix3d keyframe_told = Eigen::Matrix3d::Zero();
    Eigen::Vector3d keyframe_pull = Eigen::Vector3d::Zero();
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
    std::optional<MountWatch> mount;              ///< what all of them said; none: there was none yet
  };
  using Config = FloorConfig;
  static constexpr SensorNeed needs = {SensorKind::camera, Gaze::down, 1};
  static FloorConfig read_config(const config::Table& table) { return read_floor_config(table); }
  /// Returns what `sign` gives, of a content's bytes; none: they are no content, or give no signature.
  static std::optional<Signature> sign_bytes(ByteView bytes) {
    const Result<FloorContent> content = decode_floor_content(bytes);
    return content ? sign_features(content->features) : std::nullopt;
  }
  using Content = FloorContent;

  /// Makes a method of settings and a camera; what the camera's calibration states of itself goes into settings that
  /// are left as they are (`informed`). invalid: a setting or the calibration breaks its bound; every one is named.
  static Result<Floor> make(const FloorConfig& config, const CameraModel& camera);
  static Result<Floor> make(const FloorConfig& config, const Rig& rig) { return make(config, rig.camera()); }

  /// Returns the motion as Metric2. Blind reasons: first_view, dropped_frame, not_an_image, wrong_size, low_contrast,
  /// few_tracks, homography_refused, normal_refused, not_converged, disagrees_with_wheels, disagrees_with_command.
  Step observe(Odometry& odometry, const View* view, const Motion& motion) const;

  /// Lists the diagnostics that are watched: height_offset_m of `relate`.
  static const std::array<WatchedDiagnostic, 1> watched;
  /// Returns what driving has shown of the mount against its calibration: mount_pitch_rad, mount_roll_rad, and
  /// mount_height_share, the height's error as a share of it, which wheels show; none: not driven far enough.
  std::vector<Diagnostic> diagnose(const Odometry& odometry) const;

  /// Extracts what a place here would store. Refusals: not_an_image, wrong_size, too_blank (features found).
  OrRefusal<Content> extract(const Odometry& odometry, const View& view) const;

  Bytes encode(const Content& content) const { return encode_floor_content(content); }
  Result<Content> decode(ByteView bytes) const { return decode_floor_content(bytes); }

  /// Returns Metric2 a_from_b of the robots' level frames. With a guess, matching is guided by it (III-C); without,
  /// every heading and offset is possible. Its diagnostic: height_offset_m, by how much higher above its calibration
  /// b's camera stood than a's above its own, when the features tell it to 2 mm. Refusals: no_overlap, few_matches,
  /// no_consensus, few_inliers, few_inliers_share, not_rigid, little_overlap, little_spread, large_residual,
  /// disagrees_with_guess; ambiguous: the floor that both see looks the same elsewhere in a (moved by any motion, or,
  /// with a guess, by at most `widest_gate_m` or twice the gate, whichever is more), so that the relation is one of
  /// several.
  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const;

  /// Returns the middle of the features, in the robot's frame.
  Eigen::Vector2d gaze(const Content& content) const;

  /// Counts how often each of 512 words occurs among the features, whichever way the robot looked: views of one
  /// stretch of floor are nearer to each other than nearly all others. None: a content without features.
  std::optional<Signature> sign(const Content& content) const { return sign_features(content.features); }

  enum Condition : std::size_t { as_is, half_light, worn };
  static constexpr std::array<std::string_view, 3> conditions = {"as_is", "half_light", "worn"};
  /// Returns the view as another robot would have had it: beside, its camera mounted a little differently from what
  /// its calibration says (mount_tilt_rad, mount_height_m, load_m), on a day that is up to 30 % darker, in half that
  /// light or on a worn floor, with the sensor's noise as it is. Where it would see floor that the view does not
  /// show, there is foreign floor. Refusals: not_an_image, wrong_size.
  OrRefusal<View> simulate_view(const View& view, const Revisit& revisit) const;
  /// Returns what that robot extracts there.
  OrRefusal<Revisited<Content>> simulate_revisit(const Odometry& odometry, const View& view,
                                                 const Revisit& revisit) const;

  const CameraModel& camera() const { return camera_; }
  const FloorConfig& config() const { return config_; }

 private:
  Floor(const FloorConfig& config, const CameraModel& camera, BirdsEye birds_eye);

  FloorConfig config_;
  CameraModel camera_;
  BirdsEye birds_eye_;
  CalibrationErrors calibration_errors_;
};

}  // namespace weft::agents
