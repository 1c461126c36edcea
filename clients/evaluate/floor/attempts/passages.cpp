#include "clients/evaluate/floor/attempts/passages.hpp"

#include <algorithm>
#include <utility>

namespace weft::evaluate::floor {
namespace {

using namespace agents;

/// Returns the view with left and right changed.
View mirrored_view(const View& view) {
  const auto& image = std::get<Image>(view.data);
  Bytes pixels = *image.pixels;
  const auto width = static_cast<std::ptrdiff_t>(image.width);
  for (auto row = pixels.begin(); row != pixels.end(); row += width) std::reverse(row, row + width);
  View mirrored = view;
  mirrored.data = Image{image.width, image.height, std::make_shared<const Bytes>(std::move(pixels))};
  return mirrored;
}

std::optional<FloorContent> content_of(OrRefusal<FloorContent> content) {
  return content ? std::optional(std::move(*content)) : std::nullopt;
}

}  // namespace

Result<Passages> Passages::make(sim::SimBodyConfig config) {
  config.truth_path.reset();
  config.site.camera.fps = kFps;
  Result<std::unique_ptr<sim::SimulatedBody>> body = sim::make_sim_body(config);
  if (!body) return fail(body.error());
  Result<Floor> method = Floor::make(FloorConfig{}, (*body)->rig().camera());
  if (!method) return fail(method.error());
  return Passages(std::move(*body), std::move(*method));
}

Result<Passage> Passages::pass(const Pose2& site_from_robot, const Twist& moving) {
  const double before_s = 0.5 * (kLooks + 1) / kFps;
  const Pose2 way = se2_exp(Eigen::Vector3d(moving.linear_m_s * before_s, 0.0, moving.angular_rad_s * before_s));
  body_->put(site_from_robot * way.inverse(), moving);
  Passage passage;
  Floor::Odometry odometry;
  for (int i = 0; i < kLooks; ++i) {
    const Result<Sample> sample = body_->step(moving);
    if (!sample) return fail(sample.error());
    const View* const view = sample->of({});
    Look look;
    look.step = method_.observe(odometry, view, sample->motion);
    look.site_from_robot = body_->site_from_robot();
    if (view != nullptr) look.content = content_of(method_.extract(odometry, *view));
    if (view != nullptr && i + 1 == kLooks) passage.mirrored = content_of(method_.extract({}, mirrored_view(*view)));
    passage.looks.push_back(std::move(look));
  }
  return passage;
}

}  // namespace weft::evaluate::floor
