#pragma once
#include <cstdint>

#include "agents/bodies/sim/floor/stamp.hpp"

namespace weft::agents::sim {

/// Names the parts of a floor's look: its grey under white light and, where the light has a colour, its warmth.
enum class Channel : std::uint8_t { grey, warmth };

/// Draws one of the two: each shape is drawn on both at the same place, with its own amount.
struct Layer {
  Channel channel = Channel::grey;
  Canvas canvas;

  template <class Shape>
  void draw(Shape shape, double warmth) const {
    if (channel == Channel::warmth) shape.grey = warmth;
    stamp(shape, canvas);
  }
};

}  // namespace weft::agents::sim
