#include "clients/evaluate/stereo/dense.hpp"

#include <algorithm>
#include <cstdlib>
#include <variant>

#include "agents/perception/stereo/disparity.hpp"
#include "agents/perception/stereo/rectifier.hpp"
#include "clients/evaluate/stereo/sgbm.hpp"

namespace weft::evaluate::stereo {
namespace {

using namespace agents;

/// Returns how many disparities are searched: a recording does not say how near things are, so all that both matchers
/// can, up to a quarter of the image's width.
int disparities_of(const StereoRig& rig) {
  constexpr int step = 16;
  constexpr int fewest = 48;
  constexpr int most = 128;
  return std::clamp(rig.width / 4 / step * step, fewest, most);
}

class Comparing {
 public:
  Comparing(const StereoRig& rig, const std::function<double()>& processor_s) : processor_s_(processor_s) {
    config_.disparities = disparities_of(rig);
  }

  void add(const StereoPair& rectified) {
    ++row_.pairs;
    double began_s = processor_s_();
    const OrUnseen<DisparityMap> ours = match_disparity(config_, rectified);
    row_.ours_ms += 1e3 * (processor_s_() - began_s);
    began_s = processor_s_();
    const DisparityMap theirs = sgbm(rectified, config_.disparities);
    row_.baseline_ms += 1e3 * (processor_s_() - began_s);
    row_.baseline_dense += density(theirs);
    if (!ours) {
      ++row_.refused;
      return;
    }
    row_.ours_dense += density(*ours);
    for (std::size_t i = 0; i < theirs.sixteenths.size(); ++i) {
      if (ours->sixteenths[i] == DisparityMap::none || theirs.sixteenths[i] == DisparityMap::none) continue;
      ++both_;
      alike_ += std::abs(ours->sixteenths[i] - theirs.sixteenths[i]) <= 16 ? 1U : 0U;
    }
  }
  DenseRow finish() {
    const auto pairs = static_cast<double>(std::max<std::size_t>(1, row_.pairs));
    for (double* const sum : {&row_.ours_dense, &row_.baseline_dense, &row_.ours_ms, &row_.baseline_ms})
      *sum /= pairs;
    row_.within_1px = static_cast<double>(alike_) / static_cast<double>(std::max<std::size_t>(1, both_));
    return row_;
  }

 private:
  DisparityConfig config_;
  std::function<double()> processor_s_;
  DenseRow row_;
  std::size_t both_ = 0;
  std::size_t alike_ = 0;
};

}  // namespace

Result<std::optional<DenseRow>> match_densely(const Recording& recording, const Matching& matching) {
  const auto rectifier = Rectifier::make(recording.sensor);
  if (!rectifier) return fail(rectifier.error().code, recording.folder.string() + ": " + rectifier.error().message);
  const auto body = play(recording, matching.warn);
  if (!body) return fail(body.error());
  Comparing comparing(rectifier->rig(), matching.processor_s);
  for (std::size_t i = 0; i < recording.pairs; ++i) {
    if (matching.asked_to_stop()) return std::optional<DenseRow>();
    const Result<Sample> sample = (*body)->step({});
    if (!sample) return fail(sample.error());
    if (i % matching.every != 0 || sample->views.empty()) continue;
    if (const auto* const pair = std::get_if<StereoPair>(&sample->views.front().data))
      comparing.add(rectifier->rectified(*pair));
  }
  return std::optional(comparing.finish());
}

}  // namespace weft::evaluate::stereo
