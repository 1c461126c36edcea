#pragma once
#include "core/network/window.hpp"
#include "storage/formats/network_export.hpp"

namespace weft::formats::test {

/// Holds two experiences: a1 with four places, one blind step among its odometry, and b2 with three; a stitch between
/// them that can be driven both ways, one within a1 that cannot, and the label "dock" on the last place of b2.
struct SmallNetwork {
  Window network;
  Poses frame_from_place;
};
SmallNetwork small_network(bool spatial = false);

}  // namespace weft::formats::test
