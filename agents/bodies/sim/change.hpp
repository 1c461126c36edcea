#pragma once
#include <cstdint>
#include <vector>

#include "agents/bodies/sim/ceiling.hpp"
#include "core/geometry/pose2.hpp"

/// Describes how a site has changed since the robots were taught: [change] of a site file.
namespace weft::agents::sim {

/// Describes a dark rectangle on the floor, with soft rims; it may swing to and fro along its length.
struct CastShadow {
  Pose2 site_from_shadow;  ///< its middle, of its swing too
  double length_m = 1.2, width_m = 0.8;
  double depth = 0.5;   ///< share of all light that it takes
  double soft_m = 0.1;  ///< over which its rim fades
  double travel_m = 0.0;
  double speed_m_s = 0.4;  ///< greatest, in the middle
  double phase_rad = 0.0;  ///< of the swing when the body's time begins

  bool operator==(const CastShadow&) const = default;
};

/// Describes darker floor under a film that mirrors the lamps.
struct WetArea {
  double x = 0.0, y = 0.0;
  double radius_m = 0.6;  ///< mean; its rim is uneven

  bool operator==(const WetArea&) const = default;
};

struct PaintedLine {
  double x0 = 0.0, y0 = 0.0, x1 = 1.0, y1 = 0.0;
  double width_m = 0.1;
  double grey = 185.0;   ///< under mean light
  double warmth = 0.35;  ///< yellow

  bool operator==(const PaintedLine&) const = default;
};

/// Holds all that has changed; by default nothing has.
struct Change {
  std::uint64_t from_day = 0;  ///< bodies on earlier days see nothing of it
  std::uint64_t seed = 1;      ///< where dirt lies, and what wet rims and the lens look like
  double light = 1.0;          ///< factor on all light; the camera's exposure stays
  double light_warmth = 0.0;   ///< colour of all light: -1 blue, 0 white, 1 red
  double glare_grey = 0.0;     ///< grey levels in the middle of a lamp's mirror image, for a lamp of brightness 1
  double glare_size_m = 0.4;   ///< of that image, at the lamp
  int lens_spots = 0;          ///< blurred specks on the lens
  double lens_depth = 0.7;     ///< most that one of them takes of the light
  double dirt_per_m2 = 0.0;    ///< specks on the floor
  double stock = 0.0;          ///< share of the racks' places where something else stands
  int stock_times = 1;         ///< so often has that share changed, one time after the other
  double lamps_failed = 0.0;   ///< share of the lamps that are dark, which ones by the seed
  double ambient = 1.0;        ///< share that is left of the light from everywhere
  double skylight = 1.0;       ///< factor on the light of skylights
  double sinks_m = 0.0;        ///< bodies stand lower: under load, on worn tyres
  std::vector<CastShadow> shadows;
  std::vector<WetArea> wet;
  std::vector<PaintedLine> lines;
  std::vector<Duct> ducts;  ///< new ones

  bool operator==(const Change&) const = default;
};

}  // namespace weft::agents::sim
