#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/bytes.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Holds 8-bit grey values, row-major, no padding. Copies share the pixels, so copying is cheap.
struct Image {
  int width = 0;
  int height = 0;
  std::shared_ptr<const Bytes> pixels;
};

/// Holds two images of one moment and one exposure, which make one view and never two.
struct StereoPair {
  Image left;
  Image right;
};

/// Carries what a sensor of a test tells: bytes that only the test's own method reads.
struct Payload {
  std::shared_ptr<const Bytes> bytes;
};

/// Describes the exposure of an image: its grey levels are in proportion to both time and gain. A longer time blurs
/// what moves, a higher gain adds noise.
struct Exposure {
  double time_s = 0.0;
  double gain = 1.0;  ///< >= 1, by how much it amplifies

  double light_s() const { return time_s * gain; }  ///< as long as that without amplifying
};

/// Holds one sample of one sensor of a body.
struct View {
  std::uint64_t frame = 0;
  SensorTime time{};
  std::string sensor;       ///< its id in the body's rig
  std::string calibration;  ///< id of the calibration that belongs to this sensor
  std::variant<Image, StereoPair, Payload> data;
  std::optional<Exposure> exposure = {};  ///< none: the body does not know
};

}  // namespace weft::agents
