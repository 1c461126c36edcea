// How long a taught run of 500 places with some 150 sightings each is adjusted, in pieces and beside one Ceres solve
// of all of it; and how far its places lie from the truth before and after. Usage: adjustment_bench [PLACES]
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "agents/adjustment/mosaic_adjustment.hpp"
#include "tests/bench/times.hpp"
#include "tests/support/seen_ceiling.hpp"

namespace weft::bench {
namespace {

using namespace agents;

double off_mm(const Mosaic& mosaic, const std::vector<Pose2>& truth) {
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    sum += (mosaic.places[i].map_from_place.translation() - truth[i].translation()).squaredNorm();
  return 1e3 * std::sqrt(sum / static_cast<double>(truth.size()));
}

void adjust(const char* what, const SeenCeiling& seen, const MosaicAdjustmentConfig& config) {
  Result<MosaicAdjustment> adjustment = MosaicAdjustment::make(seen.mosaic, config);
  if (!adjustment) {
    std::printf("%s: %s\n", what, adjustment.error().message.c_str());
    return;
  }
  Took all;
  double longest_ms = 0.0;
  for (bool is_more = true; is_more;) {
    const Took piece = timed([&] { is_more = adjustment->step(); });
    all += piece;
    longest_ms = std::max(longest_ms, piece.processor_ms);
  }
  std::printf("%-12s %6zu pieces, longest %8.1f ms, all %8.1f ms of processor, places off by %.1f mm\n", what,
              adjustment->done(), longest_ms, all.processor_ms, off_mm(adjustment->mosaic(), seen.truth));
}

}  // namespace
}  // namespace weft::bench

int main(int argc, char** argv) {
  using namespace weft;
  const long given = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 500;
  if (given < 16 || given > 2000) {
    std::fprintf(stderr, "adjustment_bench: %s: places are from 16 to 2000\n", argv[1]);
    return 2;
  }
  const auto places = static_cast<std::size_t>(given);
  const agents::SeenCeiling seen({.way = agents::loop_way(places, 0.4), .stitches = 12, .seed = 11});
  std::printf("%zu places, %zu points, %zu sightings; places off by %.1f mm at first\n", places,
              seen.mosaic.points.size(), seen.mosaic.sightings.size(), bench::off_mm(seen.mosaic, seen.truth));
  bench::adjust("in windows", seen, {});
  bench::adjust("in one solve", seen, {.window_places = static_cast<std::uint32_t>(places + places % 2)});
}
