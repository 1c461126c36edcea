#include "agents/perception/stereo/census.hpp"

#include "agents/perception/stereo/semi_global.hpp"

namespace weft::agents {
namespace {

/// Returns where neighbour number 0..23 of the census lies, in the order of rows.
struct Neighbour {
  int row;     // of FiveRows
  int column;  // against the pixel
};

Neighbour neighbour(int number, bool is_mirrored) {
  const int cell = number < 12 ? number : number + 1;  // without the pixel itself
  const int column = cell % 5 - 2;
  return {cell / 5, is_mirrored ? -column : column};
}

}  // namespace

void census_row(const FiveRows& rows, int width, bool is_mirrored, std::uint8_t* planes, int plane_bytes) {
  const std::uint8_t* const centre = rows.row[2];
  for (int plane = 0; plane < semi_global::kCensusPlanes; ++plane) {
    const std::uint8_t* beside[4];
    for (int bit = 0; bit < 4; ++bit) {
      const Neighbour at = neighbour(4 * plane + bit, is_mirrored);
      beside[bit] = rows.row[at.row] + at.column;
    }
    const std::uint8_t *const a = beside[0], *const b = beside[1], *const c = beside[2], *const d = beside[3];
    std::uint8_t* __restrict const out = planes + plane * plane_bytes;
    for (int x = 0; x < width; ++x)
      out[x] = static_cast<std::uint8_t>((a[x] < centre[x] ? 1 : 0) | (b[x] < centre[x] ? 2 : 0) |
                                         (c[x] < centre[x] ? 4 : 0) | (d[x] < centre[x] ? 8 : 0));
  }
}

}  // namespace weft::agents
