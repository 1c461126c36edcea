#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/network/window.hpp"

namespace weft::formats {

/// Returns planar | spatial | along.
const char* kind_text(const Relation& relation);
/// Returns its numbers with blanks between them: "x y heading"; "x y z qx qy qz qw"; "distance heading-shift".
std::string numbers_text(const Relation& relation);
/// Returns none | a_to_b | b_to_a | both.
const char* drivable_text(Drivable drivable);

/// Returns the labels of each place that has some, with blanks between them.
std::map<PlaceId, std::string> labels_by_place(const Window& network);

}  // namespace weft::formats
