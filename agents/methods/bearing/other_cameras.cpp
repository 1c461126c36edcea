#include "agents/methods/bearing/other_cameras.hpp"

#include <algorithm>

namespace weft::agents {
namespace {

constexpr double kApart_m = 0.3;
constexpr std::size_t kMostRuns = 64;  // those that were not seen for longest go
constexpr double kOfView = 0.004;      ///< 1 sigma, of what a view says beside its own
/// Lenses bend differently, and do so in all views: no share is known better than this.
constexpr double kLeastSigma = 0.0015;

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

void OtherCameras::told(const ExperienceId& run, const FocalShare& by_view, double sigma) {
  const FocalShare before = of(run, sigma);
  const double gain = before.variance / (before.variance + by_view.variance + kOfView * kOfView);
  const double variance = std::max((1.0 - gain) * before.variance, kLeastSigma * kLeastSigma);
  std::erase_if(known_, [&](const Known& one) { return one.run == run; });
  if (known_.size() >= kMostRuns) known_.erase(known_.begin());
  known_.push_back({run, {before.share + gain * (by_view.share - before.share), variance}, 0.0});
}

}  // namespace weft::agents
