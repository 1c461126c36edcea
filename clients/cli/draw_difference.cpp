#include "clients/cli/draw_difference.hpp"

#include "clients/cli/canvas.hpp"
#include "clients/cli/difference.hpp"
#include "clients/cli/layout.hpp"

namespace weft::cli {
namespace {

constexpr Colour kSame = {0.70, 0.72, 0.75};
constexpr Colour kCame = {0.00, 0.45, 0.70};
constexpr Colour kWent = {0.84, 0.37, 0.00};
constexpr Colour kAnew = {0.00, 0.62, 0.45};

std::string revision(const Window& network) {
  return std::to_string(network.revision.value);
}

}  // namespace

Result<void> draw_difference(const Window& from, const Window& to, const std::string& note, const std::string& file) {
  const Window both = united(from, to);
  const Layout layout = lay_out(both);
  std::vector<Pose2> poses;
  for (const auto& [id, pose] : layout.drawing_from_place) poses.push_back(pose);
  Result<Canvas> canvas = Canvas::make(file, fit(poses, 3));
  if (!canvas) return fail(canvas.error());
  const auto at = [&](const PlaceId& id) { return canvas->sheet()(layout.drawing_from_place.at(id)); };
  const auto ink = [](bool was, bool is) { return was && is ? kSame : is ? kCame : kWent; };

  const NetworkDifference difference = compare(from, to);
  canvas->title("Weft network, revision " + revision(from) + " to " + revision(to),
                std::to_string(difference.places_added.size()) + " places came, " +
                    std::to_string(difference.places_removed.size()) + " went, " +
                    std::to_string(difference.places_anew.size()) + " known anew; " +
                    std::to_string(difference.stitches_added.size()) + " stitches came, " +
                    std::to_string(difference.stitches_removed.size()) + " went" + note);
  // What changed lies upon what did not.
  for (const bool changed : {false, true}) {
    for (const auto& [id, edge] : both.edges) {
      const bool was = from.edges.value(id) != nullptr;
      const bool is = to.edges.value(id) != nullptr;
      if ((was != is) != changed) continue;
      canvas->stroke(at(id.a), at(id.b), ink(was, is), edge.origin == Origin::stitch ? 1.6 : 4.0, !is);
    }
    for (const auto& [id, place] : both.places) {
      const bool was = from.place(id) != nullptr;
      const bool is = to.place(id) != nullptr;
      if ((was != is) == changed) canvas->dot(at(id), changed ? 4.0 : 3.2, ink(was, is));
    }
  }
  for (const PlaceId& id : difference.places_anew) canvas->dot(at(id), 4.0, kAnew);
  for (const auto& [label, place] : both.labels) {
    if (both.place(place) == nullptr) continue;
    const auto before = from.labels.find(label);
    const auto now = to.labels.find(label);
    const bool was = before != from.labels.end() && before->second == place;
    const bool is = now != to.labels.end() && now->second == place;
    canvas->label(at(place), label, was && is ? kInk : ink(was, is));
  }
  canvas->scale_bar();
  canvas->legend_line("in both revisions", kSame, 5.0);
  canvas->legend_line("came: in revision " + revision(to) + " alone", kCame, 5.0);
  canvas->legend_line("went: in revision " + revision(from) + " alone", kWent, 5.0, true);
  if (!difference.places_anew.empty()) canvas->legend_line("places that are known anew", kAnew, 5.0);
  return canvas->finish();
}

}  // namespace weft::cli
