#include "clients/cli/legend.hpp"

#include <algorithm>

namespace weft::cli {

std::string how_many(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : thing.ends_with("ch") ? "es" : "s");
}

std::string elided(const std::string& words, double size, double most, const WidthOf& width) {
  if (width(words, size) <= most) return words;
  std::string cut = words;
  while (!cut.empty()) {
    const auto is_within = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80; };
    while (cut.size() > 1 && is_within(cut.back())) cut.pop_back();
    cut.pop_back();
    if (width(cut + "…", size) <= most) break;
  }
  return cut + "…";
}

LegendLayout lay_legend(const Legend& legend, double wide, const WidthOf& width) {
  const double column = 0.5 * wide;
  const auto has_room = [&](const LegendLine& line) {
    return kLegendSample + width(line.words, kLegendWords) + 20.0 <= column;
  };
  const bool beside = !legend.runs.empty() && std::ranges::all_of(legend.runs, has_room) &&
                      std::ranges::all_of(legend.marks, has_room);
  LegendLayout layout;
  const auto put = [&](std::size_t count, double x, double y) {
    for (std::size_t i = 0; i < count; ++i) layout.lines.push_back({x, y + kLegendLine * static_cast<double>(i)});
    layout.height = std::max(layout.height, y + kLegendLine * static_cast<double>(count));
  };
  put(legend.runs.size(), 0.0, 0.0);
  put(legend.marks.size(), beside ? column : 0.0, beside ? 0.0 : layout.height);
  return layout;
}

}  // namespace weft::cli
