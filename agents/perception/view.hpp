#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/bytes.hpp"
#include "core/geometry/pose2.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// 8-bit grey, row-major, no padding. Shares its pixels; copying is cheap.
struct Image {
  int width = 0;
  int height = 0;
  std::shared_ptr<const Bytes> pixels;
};

/// For the test-only method `marks`: numbered marks as a noisy sensor saw them.
struct Marks {
  struct Sighting {
    std::uint64_t mark = 0;
    Pose2 robot_from_mark;
  };
  std::vector<Sighting> sightings;
};

/// One sensor sample of a body.
struct View {
  std::uint64_t frame = 0;
  SensorTime time{};
  std::string camera;
  std::string calibration;  ///< id of the calibration that belongs to this camera
  std::variant<Image, Marks> data;
};

}  // namespace weft::agents
