#pragma once
#include <cstdint>
#include <memory>
#include <optional>
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

/// How a camera takes an image: its grey levels are in proportion to both. Motion blurs by the first, noise grows
/// with the second.
struct Exposure {
  double time_s = 0.0;
  double gain = 1.0;  ///< >= 1, by how much it amplifies

  double light_s() const { return time_s * gain; }  ///< as long as that without amplifying
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
  std::optional<Exposure> exposure = {};  ///< none: the body does not know
};

}  // namespace weft::agents
