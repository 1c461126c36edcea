#include "clients/evaluate/odometry/front_end.hpp"

#include <opencv2/features2d.hpp>

#include "agents/methods/floor/config.hpp"
#include "agents/perception/attitude.hpp"
#include "agents/perception/birds_eye.hpp"
#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/direct_alignment.hpp"
#include "agents/perception/hamming.hpp"
#include "agents/perception/homography.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/opencv_view.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::evaluate::odometry {
namespace {

using namespace agents;

const FloorConfig kDefaults;
constexpr double kLeastCorrelation = 0.5;

/// Fits a motion to pairs as all front ends do: one plane explains them, then six degrees of freedom.
std::optional<PlanarFit> fitted(const CameraModel& camera, const AttitudePrior& prior,
                                const std::vector<PlanePair>& pairs, const PlanarState& expected) {
  std::vector<Eigen::Vector2d> a;
  std::vector<Eigen::Vector2d> b;
  for (const PlanePair& pair : pairs) {
    a.push_back(pair.in_a);
    b.push_back(pair.in_b);
  }
  const auto homography = robust_homography(a, b, 2.0 * kDefaults.homography_px / focal_px(camera));
  if (!homography || homography->inliers < static_cast<std::size_t>(kDefaults.fewest_tracks)) return std::nullopt;
  std::vector<PlanePair> agreeing;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (homography->inlier[i]) agreeing.push_back(pairs[i]);
  }
  PlanarFit fit = fit_planar_motion(camera, camera, agreeing, prior, expected);
  return fit.converged ? std::optional(std::move(fit)) : std::nullopt;
}

/// Follows corners from view to view, as the product follows them.
class Tracks : public FrontEnd {
 public:
  Tracks(const CameraModel& camera, const AttitudePrior& prior) : camera_(camera), prior_(prior) {}

  void look(const Image& image) override {
    last_ = now_;
    now_ = prepare_tracking(image, kDefaults.window_px, kDefaults.pyramid_levels);
  }
  void begin() override {
    in_keyframe_.clear();
    CornerConfig corners;
    corners.count = kDefaults.corners;
    pixels_ = find_corners(now_, corners);
    for (const Eigen::Vector2d& pixel : pixels_) in_keyframe_.push_back(normalised_from_pixel(camera_, pixel));
    counts_ = counts_at(now_, pixels_, kDefaults.grey_noise);
  }
  std::optional<PlanarFit> match(const PlanarState& expected) override {
    std::vector<Eigen::Vector2d> guess;
    for (const Eigen::Vector2d& point : in_keyframe_)
      guess.push_back(pixel_from_normalised(camera_, reproject(camera_, camera_, expected, point).in_b));
    const std::vector<Track> tracks = track_corners(last_, now_, pixels_, guess);
    std::vector<Eigen::Vector2d> kept;
    std::vector<Eigen::Matrix2d> counts;
    std::vector<PlanePair> pairs;
    pixels_.clear();
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      if (!tracks[i].found) continue;
      pairs.push_back(
          {in_keyframe_[i], normalised_from_pixel(camera_, tracks[i].pixel), kDefaults.track_sigma_px, counts_[i]});
      kept.push_back(in_keyframe_[i]);
      counts.push_back(counts_[i]);
      pixels_.push_back(tracks[i].pixel);
    }
    in_keyframe_ = std::move(kept);
    counts_ = std::move(counts);
    return fitted(camera_, prior_, pairs, expected);
  }

 protected:
  CameraModel camera_;
  AttitudePrior prior_;
  TrackingImage last_;
  TrackingImage now_;

 private:
  std::vector<Eigen::Vector2d> in_keyframe_;
  std::vector<Eigen::Matrix2d> counts_;
  std::vector<Eigen::Vector2d> pixels_;
};

/// Aligns grey values with the keyframe's.
class Direct : public FrontEnd {
 public:
  Direct(const CameraModel& camera, const AttitudePrior& prior) : camera_(camera), prior_(prior) {}

  void look(const Image& image) override { now_ = image; }
  void begin() override { keyframe_ = now_; }
  std::optional<PlanarFit> match(const PlanarState& expected) override {
    DirectFit found = align_directly(camera_, keyframe_, now_, prior_, expected, {});
    if (!found.fit.converged || found.correlation < kLeastCorrelation) return std::nullopt;
    return std::move(found.fit);
  }

 private:
  CameraModel camera_;
  AttitudePrior prior_;
  Image keyframe_;
  Image now_;
};

/// Tracks corners from where an alignment of coarse levels expects them.
class DirectThenTracks : public Tracks {
 public:
  using Tracks::Tracks;
  void look(const Image& image) override {
    Tracks::look(image);
    view_ = image;
  }
  void begin() override {
    Tracks::begin();
    keyframe_ = view_;
  }
  std::optional<PlanarFit> match(const PlanarState& expected) override {
    DirectConfig coarse;
    coarse.finest = 2;
    const DirectFit found = align_directly(camera_, keyframe_, view_, prior_, expected, coarse);
    const bool is_better = found.fit.converged && found.correlation >= kLeastCorrelation;
    return Tracks::match(is_better ? found.fit.state : expected);
  }

 private:
  Image keyframe_;
  Image view_;
};

struct Described {
  std::vector<Eigen::Vector2d> normalised;
  std::vector<Descriptor> descriptors;
};

/// Matches binary features of both views, near where they are expected.
class Matches : public FrontEnd {
 public:
  Matches(const CameraModel& camera, const AttitudePrior& prior) : camera_(camera), prior_(prior) {}

  void look(const Image& image) override { now_ = describe(image); }
  void begin() override { keyframe_ = now_; }
  std::optional<PlanarFit> match(const PlanarState& expected) override {
    constexpr double gate_px = 60.0;
    constexpr double sigma_px = 0.7;
    const double gate = gate_px / focal_px(camera_);
    std::vector<std::vector<std::uint32_t>> candidates_of_b(now_.normalised.size());
    for (std::size_t i = 0; i < keyframe_.normalised.size(); ++i) {
      const Reprojection there = reproject(camera_, camera_, expected, keyframe_.normalised[i]);
      for (std::size_t k = 0; there.in_front && k < now_.normalised.size(); ++k) {
        if ((now_.normalised[k] - there.in_b).cwiseAbs().maxCoeff() < gate)
          candidates_of_b[k].push_back(static_cast<std::uint32_t>(i));
      }
    }
    const MatchBounds bounds{kDefaults.most_bits, kDefaults.ratio};
    std::vector<PlanePair> pairs;
    for (const Match& m : match_descriptors(keyframe_.descriptors, now_.descriptors, bounds, candidates_of_b))
      pairs.push_back({keyframe_.normalised[m.a], now_.normalised[m.b], sigma_px});
    return fitted(camera_, prior_, pairs, expected);
  }

 protected:
  virtual Described describe(const Image& image) = 0;
  CameraModel camera_;

 private:
  AttitudePrior prior_;
  Described keyframe_;
  Described now_;
};

class OrbOfTheImage final : public Matches {
 public:
  using Matches::Matches;

 private:
  Described describe(const Image& image) override {
    std::vector<cv::KeyPoint> keypoints;
    cv::Mat descriptors;
    orb_->detectAndCompute(as_mat(image), {}, keypoints, descriptors);
    Described out;
    for (std::size_t i = 0; i < keypoints.size(); ++i) {
      out.normalised.push_back(normalised_from_pixel(camera_, {keypoints[i].pt.x, keypoints[i].pt.y}));
      Descriptor descriptor;
      std::memcpy(descriptor.data(), descriptors.ptr(static_cast<int>(i)), sizeof(Descriptor));
      out.descriptors.push_back(descriptor);
    }
    return out;
  }
  cv::Ptr<cv::ORB> orb_ = cv::ORB::create(500, 1.2F, 3, 31, 0, 2, cv::ORB::HARRIS_SCORE, 31, 8);
};

class FeaturesOfTheFloor final : public Matches {
 public:
  FeaturesOfTheFloor(const CameraModel& camera, const AttitudePrior& prior)
      : Matches(camera, prior),
        birds_eye_(camera, {kDefaults.far_m, kDefaults.half_width_m, kDefaults.metres_per_pixel}) {}

 private:
  Described describe(const Image& image) override {
    Described out;
    const Eigen::Matrix3d camera_from_level = camera_from_floor(camera_, {});
    for (const PlaneFeature& feature :
         birds_eye_.rectify(image, kDefaults.features, kDefaults.patch_metres_per_pixel).features) {
      out.normalised.push_back(apply(camera_from_level, feature.on_plane));
      out.descriptors.push_back(feature.descriptor);
    }
    return out;
  }
  BirdsEye birds_eye_;
};

constexpr const char* kTracks = "KLT tracks";
constexpr const char* kDirect = "direct alignment";
constexpr const char* kDirectThenTracks = "direct, then KLT";
constexpr const char* kOrb = "ORB of the image";
constexpr const char* kFloorFeatures = "features of the floor";

}  // namespace

const std::vector<std::string>& front_ends() {
  static const std::vector<std::string> all = {kTracks, kDirect, kDirectThenTracks, kOrb, kFloorFeatures};
  return all;
}

std::unique_ptr<FrontEnd> make_front_end(const std::string& name, const CameraModel& camera,
                                         const AttitudePrior& prior) {
  if (name == kDirect) return std::make_unique<Direct>(camera, prior);
  if (name == kDirectThenTracks) return std::make_unique<DirectThenTracks>(camera, prior);
  if (name == kOrb) return std::make_unique<OrbOfTheImage>(camera, prior);
  if (name == kFloorFeatures) return std::make_unique<FeaturesOfTheFloor>(camera, prior);
  return std::make_unique<Tracks>(camera, prior);
}

}  // namespace weft::evaluate::odometry
