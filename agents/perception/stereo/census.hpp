#pragma once
#include <cstdint>

namespace weft::agents {

/// Points to the five rows around a row of an image, at their first pixels; two pixels before and behind can be read.
struct FiveRows {
  const std::uint8_t* row[5] = {};  ///< [2] is the row itself
};

/// Describes each pixel of a row by which of its 24 neighbours in 5x5 are darker (census, Zabih & Woodfill 1994):
/// four bits a byte, so that a table of sixteen counts the bits, in kCensusPlanes planes of `plane_bytes` each.
/// `is_mirrored`: the rows run from right to left, and the description is that of the image as it was.
void census_row(const FiveRows& rows, int width, bool is_mirrored, std::uint8_t* planes, int plane_bytes);

}  // namespace weft::agents
