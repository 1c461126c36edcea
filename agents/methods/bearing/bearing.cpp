#include "agents/methods/bearing/bearing.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/exposure.hpp"
#include "agents/perception/looming.hpp"
#include "agents/perception/opencv_view.hpp"
#include "agents/perception/scene_inliers.hpp"

namespace weft::agents {
namespace {

/// Returns the image at the focal length that contents are of.
Image resampled(const Image& image, double scale) {
  constexpr double same = 1e-3;
  if (std::abs(scale - 1.0) < same) return image;
  cv::Mat out;
  cv::resize(as_mat(image), out, {}, scale, scale, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
  return {out.cols, out.rows, std::make_shared<const Bytes>(out.datastart, out.dataend)};
}

/// Returns why the view is no image of the camera; empty: it is one.
std::string_view what_is_wrong(const View& view, const CameraModel& camera) {
  const auto* const image = std::get_if<Image>(&view.data);
  if (image == nullptr) return "not_an_image";
  if (!is_whole(*image) || image->width != camera.width || image->height != camera.height) return "wrong_size";
  return {};
}

}  // namespace

Result<Bearing> Bearing::make(const BearingConfig& config, const CameraModel& camera) {
  std::string issues;
  for (const std::string& issue : check(config)) issues += (issues.empty() ? "" : "\n") + issue;
  if (!(camera.fx > 10.0 && camera.fx < 1e4))
    issues += (issues.empty() ? "" : "\n") + ("camera " + camera.id + ": focal length " + std::to_string(camera.fx) +
                                              " px is not within [10, 10000]");
  if (!issues.empty()) return fail(ErrorCode::invalid, issues);
  return Bearing(config, camera);
}

Step Bearing::observe(Odometry& odometry, const View* view, const Motion& motion) const {
  const double elapsed_s = seconds(motion.elapsed);
  const bool wheels = motion.wheels.has_value();
  const double distance = wheels ? motion.wheels->distance_m : motion.command.linear_m_s * elapsed_s;
  const double turn = wheels ? motion.wheels->heading_rad : motion.command.angular_rad_s * elapsed_s;
  if (elapsed_s > 0.0) odometry.driving = {distance / elapsed_s, turn / elapsed_s};
  Step step;
  step.common(0, 0) = distance * (wheels ? config_.wheel_distance_share : config_.command_distance_share);
  step.common(kYaw, 1) = distance * (wheels ? config_.wheel_turn_rad_m : config_.command_turn_rad_m);
  const double way = std::abs(distance);
  const double turned = std::abs(turn);
  constexpr double turns_m = 0.2;  // a radian slips as much as this way
  const double slips = way + turns_m * turned;
  step.previous_from_current =
      AlongPath{distance, step.common(0, 0) * step.common(0, 0) + config_.slip_m * config_.slip_m * slips, turn,
                step.common(kYaw, 1) * step.common(kYaw, 1) + config_.slip_rad * config_.slip_rad * slips};
  step.blind_reason = view == nullptr ? std::string_view("no_view") : what_is_wrong(*view, camera_);
  step.seen = step.blind_reason.empty();
  return step;
}

std::optional<Exposure> Bearing::expose(const Odometry& odometry, const View& view) const {
  if (!view.exposure || !what_is_wrong(view, camera_).empty()) return std::nullopt;
  constexpr double passed_rad_m = 0.2;  // what stands a metre aside, at the image's edge
  const double turning_rad_s =
      std::abs(odometry.driving.angular_rad_s) + passed_rad_m * std::abs(odometry.driving.linear_m_s);
  const double factor = exposure_factor(std::get<Image>(view.data), view.exposure->gain, config_.exposure);
  return brightened(*view.exposure, factor, camera_.fx * turning_rad_s, config_.exposure);
}

OrRefusal<Bearing::Content> Bearing::extract(const Odometry& odometry, const View& view) const {
  if (const std::string_view wrong = what_is_wrong(view, camera_); !wrong.empty())
    return tl::unexpected(Refusal{wrong});
  const double scale = config_.focal_px / camera_.fx;
  const Image image = resampled(std::get<Image>(view.data), scale);
  Content content;
  content.focal_px = config_.focal_px;
  content.driving = odometry.driving;
  content.description = config_.features.description;
  UprightConfig features = config_.features;
  features.cell_widths *= static_cast<double>(config_.width_px) / image.width;
  content.features = upright_features(image, features);
  const Eigen::Vector2f middle = (scale * Eigen::Vector2d(camera_.cx, camera_.cy)).cast<float>();
  for (UprightFeature& feature : content.features) feature.pixel -= middle;
  const auto found = static_cast<double>(content.features.size());
  if (found < config_.vote.fewest_features)
    return tl::unexpected(Refusal{"few_features", found, static_cast<double>(config_.vote.fewest_features)});
  return content;
}

OrRefusal<Related> Bearing::relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const {
  if (a.description != b.description) return tl::unexpected(Refusal{"described_otherwise"});
  const double rise_px = frequent_rise(a.features, b.features, config_.width_px, config_.vote);
  const auto vote = vote_heading(a.features, b.features, config_.width_px, config_.vote, rise_px);
  if (!vote) return tl::unexpected(Refusal{vote.error().reason, vote.error().measured, vote.error().bound});
  if (!guess && vote->above_chance < config_.anywhere_above_chance)
    return tl::unexpected(Refusal{"no_majority", vote->above_chance, config_.anywhere_above_chance});
  if (!guess && vote->runner_up > config_.anywhere_runner_up)
    return tl::unexpected(Refusal{"ambiguous", vote->runner_up, config_.anywhere_runner_up});
  if (!guess) {
    const auto looming = looming_of(a.features, b.features, vote->agreeing, a.focal_px);
    const double bound = config_.anywhere_looming + (looming ? 2.0 * std::sqrt(looming->variance) : 0.0);
    if (looming && std::abs(looming->share) > bound)
      return tl::unexpected(Refusal{"further_off", looming->share, bound});
    const double inliers = scene_inliers(a.features, b.features, vote->agreeing, a.focal_px, config_.inlier_px);
    if (inliers < config_.anywhere_inliers)
      return tl::unexpected(Refusal{"another_scene", inliers, static_cast<double>(config_.anywhere_inliers)});
  }
  AlongPath a_from_b{0.0, config_.unknown_along_sigma_m * config_.unknown_along_sigma_m};
  if (guess) {
    const auto along = std::get<AlongPath>(compose(*guess, AlongPath{}));
    a_from_b.distance_m = along.distance_m;
    a_from_b.distance_variance_m2 = std::max(along.distance_variance_m2, 1e-8);
  }
  // What a robot that has turned left sees has moved to the right.
  a_from_b.heading_shift_rad = std::atan(vote->shift_px / a.focal_px);
  a_from_b.heading_variance_rad2 = config_.vote_sigma_rad * config_.vote_sigma_rad * (1.0 + 20.0 / vote->votes);
  return Related{a_from_b, vote->votes, static_cast<double>(vote->votes) / std::max(1U, vote->matches),
                 vote->runner_up};
}

double Bearing::most_of_rival(double likeness) const {
  return std::min(config_.anywhere_rival * likeness, static_cast<double>(config_.anywhere_rival_inliers));
}

double Bearing::likeness(const Content& a, const Content& b) const {
  if (a.description != b.description) return 0.0;
  const double rise_px = frequent_rise(a.features, b.features, config_.width_px, config_.vote);
  const auto vote = vote_heading(a.features, b.features, config_.width_px, config_.vote, rise_px);
  if (!vote) return 0.0;
  return scene_inliers(a.features, b.features, vote->agreeing, a.focal_px, config_.inlier_px);
}

}  // namespace weft::agents
