#include "agents/methods/bearing/other_cameras.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {
namespace {

constexpr double kApart_m = 0.3;
constexpr std::size_t kMostRuns = 64;  // those that were not seen for longest go
constexpr double kOfView = 0.004;      ///< 1 sigma, of what a view says beside its own
/// Bounds sigma from below: lenses bend differently, and do so in all views, so no share is known better.
constexpr double kLeastSigma = 0.0015;

constexpr double kSurprising = 2.5;  // sigma
constexpr std::size_t kRiseViews = 5;

}  // namespace

const OtherCameras::Known* OtherCameras::find(const ExperienceId& run) const {
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& one) { return one.run == run; });
  return found == known_.end() ? nullptr : &*found;
}

FocalShare OtherCameras::of(const ExperienceId& run, double sigma) const {
  const Known* const known = find(run);
  return known != nullptr ? known->share : FocalShare{0.0, sigma * sigma};
}

void OtherCameras::moved(double metres) {
  for (Known& one : known_) one.since_m += metres;
}

bool OtherCameras::is_due(const ExperienceId& run) const {
  const Known* const known = find(run);
  return known == nullptr || known->since_m >= kApart_m;
}

void OtherCameras::told(const CameraLook& by_view, double sigma) {
  const FocalShare before = of(by_view.run, sigma);
  const double differs = before.variance + by_view.share.variance + kOfView * kOfView;
  const double gain = before.variance / differs;
  // What surprises counts as what just does not, so that no view by itself decides, and many do.
  const double surprise = kSurprising * std::sqrt(differs);
  const double by = std::clamp(by_view.share.share - before.share, -surprise, surprise);
  const double variance = std::max((1.0 - gain) * before.variance, kLeastSigma * kLeastSigma);
  std::erase_if(known_, [&](const Known& one) { return one.run == by_view.run; });
  if (known_.size() >= kMostRuns) known_.erase(known_.begin());
  known_.push_back({by_view.run, {before.share + gain * by, variance}, 0.0});
}

std::optional<double> OtherCameras::rise_px(const ExperienceId& run) const {
  const auto found = std::find_if(risen_.begin(), risen_.end(), [&](const Risen& one) { return one.run == run; });
  if (found == risen_.end() || found->by_px.size() < kRiseViews) return std::nullopt;
  return found->by_px[kRiseViews / 2];
}

void OtherCameras::told(const CameraRise& by_view) {
  auto found = std::find_if(risen_.begin(), risen_.end(), [&](const Risen& one) { return one.run == by_view.run; });
  if (found == risen_.end()) {
    if (risen_.size() >= kMostRuns) risen_.erase(risen_.begin());
    found = risen_.insert(risen_.end(), Risen{by_view.run, {}});
  }
  if (found->by_px.size() >= kRiseViews) return;
  found->by_px.insert(std::upper_bound(found->by_px.begin(), found->by_px.end(), by_view.px), by_view.px);
}

}  // namespace weft::agents
