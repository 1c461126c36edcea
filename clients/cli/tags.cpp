#include <algorithm>

#include "clients/cli/picture.hpp"

namespace weft::cli {

Tag make_tag(const std::string& words, const Point& anchor, double clear, const WidthOf& width) {
  constexpr double padding = 4.0;  // and what a letter may lean over its width
  return {words, {anchor, clear, width(words, kTagWords) + 2.0 * padding, kTagWords + 2.0 * padding}};
}

void place(std::vector<Tag>& tags, const std::vector<Box>& marks, const std::vector<Point>& points, Sheet& sheet,
           double legend_height) {
  std::vector<LabelWish> wishes;
  for (const Tag& tag : tags) wishes.push_back(tag.wish);
  const LabelPlacement placed = place_labels(wishes, marks, points, sheet.room());
  for (std::size_t i = 0; i < tags.size(); ++i) tags[i].box = placed.boxes[i];
  sheet.grow(placed.frame, legend_height);
}

}  // namespace weft::cli
