#pragma once
#include <cstdint>

#include "core/geometry/pose2.hpp"

/// Describes what a hall's ceiling is made of and what hangs under it; docs/simulation.md, "The ceiling".
namespace weft::agents::sim {

/// Names what the ceiling itself is made of.
enum class CeilingKind : std::uint8_t {
  plain,     ///< one texture of sheet metal, in panels that do not match: for cameras that look ahead
  bare,      ///< painted, with nothing to see on it
  concrete,  ///< cast in boards, with tie holes, cables and dirt
  sheet,     ///< corrugated steel with screws, rust and dirt
  panels     ///< mineral fibre panels in a metal grid
};

/// Describes an air duct: a box that hangs level and straight.
struct Duct {
  double x0 = 0.0, y0 = 0.0, x1 = 1.0, y1 = 0.0;  ///< along its middle
  double below_m = 0.6;                           ///< from the ceiling down to its top
  double width_m = 0.6, height_m = 0.4;
  double grey = 150.0;

  bool operator==(const Duct&) const = default;
};

/// Describes a pipe, which hangs level and straight.
struct Pipe {
  double x0 = 0.0, y0 = 0.0, x1 = 1.0, y1 = 0.0;
  double below_m = 0.5;  ///< from the ceiling down to its axis
  double diameter_m = 0.11;
  double grey = 120.0;

  bool operator==(const Pipe&) const = default;
};

/// Describes a window in the ceiling.
struct Skylight {
  Pose2 site_from_skylight;  ///< its middle
  double length_m = 2.0, width_m = 1.0;
  double brightness = 1.0;  ///< 1: as bright as a lamp of brightness 1, if it is as large as 2 m x 1 m
};

/// Describes what of the ceiling is not listed one by one; 0 m apart: there are none.
struct CeilingSetup {
  CeilingKind kind = CeilingKind::plain;
  double beams_every_m = 5.0;
  double sprinklers_every_m = 0.0;
  double signs_every_m = 0.0;
  double dirt = 1.0;           ///< factor on how many specks, screws' stains and the like there are
  double stains_per_m2 = 0.0;  ///< large ones
  double lamp_length_m = 1.2, lamp_width_m = 0.3;  ///< of each lamp's face; its length along x
};

}  // namespace weft::agents::sim
