#pragma once
#include <benchmark/benchmark.h>

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/perception/opencv_view.hpp"
#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

/// Holds what the benches of the ceiling method look at, rendered once.
namespace weft::bench {

inline constexpr double kCeilingM = 6.4;
inline constexpr double kViewStepM = 0.06;

/// Holds 30 views of 640 by 480 pixels at 0.6 m/s and 10 fps, straight on below beams, ducts and lamps.
struct CeilingViews {
  static agents::CeilingConfig config() {
    agents::CeilingConfig config;
    config.height_m = kCeilingM;
    return config;
  }

  agents::Ceiling method = *agents::Ceiling::make(config(), test::up_camera());
  std::vector<agents::View> views;
  std::vector<agents::CeilingContent> contents;
  agents::Motion motion;
};

inline const CeilingViews& views() {
  static const CeilingViews made = [] {
    CeilingViews v;
    test::RenderedCeiling hall = test::hall_ceiling(kCeilingM);
    for (int i = 0; i < 30; ++i) {
      v.views.push_back(
          hall.view(v.method.camera(), {kViewStepM * i, 0.0, 0.0}, {}, static_cast<std::uint64_t>(i) + 1));
      v.contents.push_back(*v.method.extract({}, v.views.back()));
    }
    v.motion.elapsed = std::chrono::milliseconds(100);
    v.motion.command = {10.0 * kViewStepM, 0.0};
    v.motion.wheels = agents::WheelStep{kViewStepM, 0.0};
    return v;
  }();
  return made;
}

inline cv::Mat grey(const agents::View& view) {
  return agents::as_mat(std::get<agents::Image>(view.data));
}

}  // namespace weft::bench
