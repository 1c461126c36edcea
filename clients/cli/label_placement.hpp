#pragma once
#include <vector>

#include "clients/cli/sheet.hpp"

namespace weft::cli {

/// Describes a label that is to be placed near what it names.
struct LabelWish {
  Point anchor;
  double clear = 0.0;  ///< radius of the mark at the anchor, which no label covers
  double wide = 0.0;
  double tall = 0.0;
};

struct LabelPlacement {
  std::vector<Box> boxes;  ///< one a wish, in their order
  Box frame;               ///< as given, larger where there was no room
};

/// Places labels one after the other: each as near to its anchor as there is room, where it covers the fewest of
/// `points`. No box covers another one, a mark at an anchor, or one of `marks`; all lie in the frame that is
/// returned. Labels without room near their anchors go in rows below the frame. Pure; the same wishes give the same
/// boxes.
LabelPlacement place_labels(const std::vector<LabelWish>& wishes, const std::vector<Box>& marks,
                            const std::vector<Point>& points, const Box& frame);

/// Returns whether the two boxes share more than an edge.
bool overlap(const Box& a, const Box& b);
/// Returns the point of the box that is nearest to `at`: where a leader line from an anchor ends.
Point nearest_in(const Box& box, const Point& at);
/// Returns whether the box lies so far from its anchor that a line must say what it belongs to.
bool needs_leader(const LabelWish& wish, const Box& box);

}  // namespace weft::cli
