#include "clients/cli/draw_difference.hpp"

#include "clients/cli/difference.hpp"
#include "clients/cli/layout.hpp"
#include "clients/cli/paint_legend.hpp"
#include "clients/cli/paint_sheet.hpp"

namespace weft::cli {
namespace {

using Sample = LegendLine::Sample;

constexpr Colour kSame = {0.70, 0.72, 0.75};
constexpr Colour kCame = {0.00, 0.45, 0.70};
constexpr Colour kWent = {0.84, 0.37, 0.00};
constexpr Colour kAnew = {0.00, 0.62, 0.45};
constexpr double kChangedRadius = 4.0;

std::string revision(const Window& network) {
  return std::to_string(network.revision.value);
}

const Colour& ink_of(bool was, bool is) {
  return was && is ? kSame : is ? kCame : kWent;
}

std::string difference_detail(const NetworkDifference& difference, const std::string& note) {
  return std::to_string(difference.places_added.size()) + " places came, " +
         std::to_string(difference.places_removed.size()) + " went, " +
         std::to_string(difference.places_anew.size()) + " known anew; " +
         std::to_string(difference.stitches_added.size()) + " stitches came, " +
         std::to_string(difference.stitches_removed.size()) + " went" + note;
}

Legend difference_legend(const Window& from, const Window& to, const NetworkDifference& difference, bool has_labels) {
  Legend legend;
  legend.runs = {{Sample::run, "in both revisions", kSame, kThickRun},
                 {Sample::run, "came: in revision " + revision(to) + " alone", kCame, kThickRun},
                 {Sample::line, "went: in revision " + revision(from) + " alone", kWent, kThickRun, true}};
  legend.marks = {{Sample::line, "a thin line is a stitch: the same spot, seen twice", kSame, kThickStitch}};
  if (!difference.places_anew.empty())
    legend.marks.push_back({Sample::dot, "place that is known anew", kAnew, kChangedRadius});
  if (has_labels)
    legend.marks.push_back({Sample::label, "labelled place; its colour says whether its label came or went"});
  return legend;
}

/// Shows both revisions as one network.
class TwoRevisions {
 public:
  TwoRevisions(const Window& from, const Window& to)
      : from_(from), to_(to), both_(united(from, to)), layout_(lay_out(both_)), difference_(compare(from, to)) {}

  const Window& network() const { return both_; }
  const Layout& layout() const { return layout_; }
  const NetworkDifference& difference() const { return difference_; }

  /// Paints what changed upon what did not.
  void paint(drawing::Canvas& canvas, const Sheet& sheet) const {
    const auto at = [&](const PlaceId& id) { return sheet(layout_.drawing_from_place.at(id)); };
    for (const bool changed : {false, true}) {
      for (const auto& [id, edge] : both_.edges) {
        const bool was = from_.edges.value(id) != nullptr;
        const bool is = to_.edges.value(id) != nullptr;
        if ((was != is) != changed) continue;
        const double thick = edge.origin == Origin::stitch ? kThickStitch : kThickRun;
        canvas.stroke(at(id.a), at(id.b), ink_of(was, is), {thick, !is});
      }
      for (const auto& [id, place] : both_.places) {
        const bool was = from_.place(id) != nullptr;
        const bool is = to_.place(id) != nullptr;
        if ((was != is) == changed) canvas.dot(at(id), changed ? kChangedRadius : kPlaceRadius, ink_of(was, is));
      }
    }
    for (const PlaceId& id : difference_.places_anew) canvas.dot(at(id), kChangedRadius, kAnew);
  }

  std::vector<Tag> tags(const Sheet& sheet, const WidthOf& width) const {
    std::vector<Tag> tags;
    for (const auto& [label, place] : both_.labels) {
      if (both_.place(place) == nullptr || tags.size() >= kMostLabels) continue;
      const auto before = from_.labels.find(label);
      const auto now = to_.labels.find(label);
      const bool was = before != from_.labels.end() && before->second == place;
      const bool is = now != to_.labels.end() && now->second == place;
      Tag tag = make_tag(label, sheet(layout_.drawing_from_place.at(place)), kLabelRadius, width);
      tag.ink = was && is ? kInk : ink_of(was, is);
      tags.push_back(std::move(tag));
    }
    return tags;
  }

 private:
  const Window& from_;
  const Window& to_;
  Window both_;
  Layout layout_;
  NetworkDifference difference_;
};

}  // namespace

Result<void> draw_difference(const Window& from, const Window& to, const std::string& note, const std::string& file) {
  const TwoRevisions both(from, to);
  const WidthOf width = text_widths();
  std::vector<Pose2> poses;
  for (const auto& [id, pose] : both.layout().drawing_from_place) poses.push_back(pose);
  Sheet sheet = fit(poses);
  std::vector<Point> points;
  for (const Pose2& pose : poses) points.push_back(sheet(pose));
  std::vector<Tag> tags = both.tags(sheet, width);
  const double wide = sheet.width - 2.0 * kSheetMargin;
  const Legend legend = difference_legend(from, to, both.difference(), !tags.empty());
  const LegendLayout legend_layout = lay_legend(legend, wide, width);
  place(tags, {}, points, sheet, legend_layout.height);

  Result<drawing::Canvas> canvas = drawing::Canvas::make(file, sheet.width, sheet.height);
  if (!canvas) return fail(canvas.error());
  paint_head(*canvas, sheet, "Weft network, revision " + revision(from) + " to " + revision(to),
             elided(difference_detail(both.difference(), note), kDetailWords, wide, width));
  both.paint(*canvas, sheet);
  for (const Tag& tag : tags) paint_ring(*canvas, tag.wish.anchor, tag.ink);
  paint_tags(*canvas, tags);
  paint_legend(*canvas, legend, legend_layout, sheet.legend_top);
  return canvas->finish();
}

}  // namespace weft::cli
