#include "clients/cli/draw.hpp"

#include <algorithm>
#include <array>

#include "clients/cli/canvas.hpp"
#include "clients/cli/layout.hpp"
#include "clients/cli/plan_paint.hpp"
#include "storage/formats/import.hpp"

namespace weft::cli {
namespace {

/// Told apart by people who see colours differently (Okabe & Ito).
constexpr std::array<Colour, 7> kColours = {{{0.00, 0.45, 0.70},
                                             {0.84, 0.37, 0.00},
                                             {0.00, 0.62, 0.45},
                                             {0.80, 0.47, 0.65},
                                             {0.90, 0.62, 0.00},
                                             {0.34, 0.71, 0.91},
                                             {0.55, 0.45, 0.20}}};
constexpr Colour kStitch = {0.45, 0.20, 0.55};
constexpr double kThin = 0.6;  // of a stitch that nobody drives over

/// What must be on the sheet.
std::vector<Pose2> outline(const Layout& layout, const std::optional<Ground>& ground) {
  std::vector<Pose2> poses;
  for (const auto& [id, pose] : layout.drawing_from_place) poses.push_back(pose);
  if (ground.has_value()) {
    for (const Pose2& corner : corners_of(ground->plan)) poses.push_back(corner);
  }
  return poses;
}

std::string count_of(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : thing.ends_with("ch") ? "es" : "s");
}

class Drawing {
 public:
  Drawing(Canvas& canvas, const Layout& layout, const Window& network)
      : canvas_(canvas), layout_(layout), network_(network) {
    for (const auto& [id, place] : network.places) {
      if (colours_.contains(id.experience)) continue;
      colours_.emplace(id.experience, kColours.at(colours_.size() % kColours.size()));
    }
  }

  Result<void> ground(const Ground& ground) {
    const Sheet& sheet = canvas_.sheet();
    const Point origin = sheet(Pose2{});
    cairo_matrix_t sheet_from_plan{};
    cairo_matrix_init(&sheet_from_plan, sheet.scale, 0.0, 0.0, -sheet.scale, origin.x, origin.y);
    caption_ = ", " + ground.caption;
    return paint(canvas_.pen(), ground.plan, sheet_from_plan);
  }

  void title() {
    std::size_t stitches = 0;
    for (const auto& [id, edge] : network_.edges) stitches += edge.origin == Origin::stitch ? 1 : 0;
    std::string detail = count_of(colours_.size(), "experience") + ", " + count_of(network_.places.size(), "place") +
                         ", " + count_of(stitches, "stitch");
    if (layout_.islands > 1) detail += ", " + std::to_string(layout_.islands) + " parts that nothing joins";
    canvas_.title("Weft network, revision " + std::to_string(network_.revision.value), detail + caption_);
  }

  void edges() {
    for (const auto& [id, edge] : network_.edges) {
      if (edge.origin != Origin::stitch) path(id, colours_.at(id.a.experience), 4.0, edge.origin == Origin::blind);
    }
    for (const auto& [id, place] : network_.places) canvas_.dot(at(id), 3.2, colours_.at(id.experience));
    for (const auto& [id, edge] : network_.edges) {
      if (edge.origin == Origin::stitch) path(id, kStitch, edge.drivable == Drivable::none ? kThin : 1.6, false);
    }
  }

  void labels() {
    for (const auto& [label, place] : network_.labels) {
      if (layout_.drawing_from_place.contains(place)) canvas_.label(at(place), label, kInk);
    }
  }

  void robots(const std::vector<msg::RobotRow>& rows) {
    for (const msg::RobotRow& row : rows) {
      const auto found = layout_.drawing_from_place.find(row.state.place);
      if (!row.state.place || found == layout_.drawing_from_place.end()) continue;
      robot(found->second * planar(row.state.place_from_robot), row.description.name);
    }
  }

  void legend(const Names& names) {
    for (const auto& [id, ink] : colours_) {
      std::size_t places = 0;
      std::string taught;
      for (const auto& [place, held] : network_.places) {
        if (place.experience != id) continue;
        if (places++ > 0) continue;
        taught = held.method == kImportedMethod ? "imported" : "taught by " + name_of(names, held.robot);
      }
      canvas_.legend_line(taught + ": " + count_of(places, "place") + ", experience " + to_string(id), ink, 5.0);
    }
    canvas_.legend_line("stitch: the same spot, seen in two runs", kStitch, 1.6);
    if (has_met(network_)) canvas_.legend_line("thin: nobody can change over there", kStitch, kThin);
    if (has_blind(network_)) canvas_.legend_line("dashed: joined by odometry alone", kInk, 4.0, true);
  }

  static std::size_t legend_lines(const Window& network) {
    std::size_t experiences = 0;
    ExperienceId last;
    for (const auto& [id, place] : network.places) {
      experiences += id.experience != last ? 1 : 0;
      last = id.experience;
    }
    return experiences + 1 + (has_blind(network) ? 1 : 0) + (has_met(network) ? 1 : 0);
  }

 private:
  static bool has_blind(const Window& network) {
    return std::any_of(network.edges.begin(), network.edges.end(),
                       [](const auto& entry) { return entry.second.origin == Origin::blind; });
  }

  static bool has_met(const Window& network) {
    return std::any_of(network.edges.begin(), network.edges.end(), [](const auto& entry) {
      return entry.second.origin == Origin::stitch && entry.second.drivable == Drivable::none;
    });
  }

  Point at(const PlaceId& id) const { return canvas_.sheet()(layout_.drawing_from_place.at(id)); }

  void path(const EdgeId& id, const Colour& ink, double thick, bool dashed) {
    canvas_.stroke(at(id.a), at(id.b), ink, thick, dashed);
  }

  void robot(const Pose2& drawing_from_robot, const std::string& name) {
    cairo_t* const pen = canvas_.pen();
    const Point at = canvas_.sheet()(drawing_from_robot);
    cairo_save(pen);
    cairo_translate(pen, at.x, at.y);
    cairo_rotate(pen, -drawing_from_robot.heading);
    cairo_move_to(pen, 16.0, 0.0);
    cairo_line_to(pen, -10.0, 10.0);
    cairo_line_to(pen, -5.0, 0.0);
    cairo_line_to(pen, -10.0, -10.0);
    cairo_close_path(pen);
    cairo_set_source_rgb(pen, 0.98, 0.80, 0.10);
    cairo_fill_preserve(pen);
    cairo_set_source_rgb(pen, kInk.r, kInk.g, kInk.b);
    cairo_set_line_width(pen, 1.6);
    cairo_stroke(pen);
    cairo_restore(pen);
    canvas_.tag({at.x, at.y + 34.0}, name, 14.0, kInk);
  }

  Canvas& canvas_;
  const Layout& layout_;
  const Window& network_;
  std::map<ExperienceId, Colour> colours_;
  std::string caption_;
};

}  // namespace

Result<void> draw(const Window& network, const std::vector<msg::RobotRow>& robots, const std::string& file) {
  return draw(network, lay_out(network), std::nullopt, robots, file);
}

Result<void> draw(const Window& network, const Layout& layout, const std::optional<Ground>& ground,
                  const std::vector<msg::RobotRow>& robots, const std::string& file) {
  Result<Canvas> canvas = Canvas::make(file, fit(outline(layout, ground), Drawing::legend_lines(network)));
  if (!canvas) return fail(canvas.error());
  Names names;
  for (const msg::RobotRow& row : robots) names[row.description.header.sender] = row.description.name;
  Drawing drawing(*canvas, layout, network);
  if (ground.has_value()) {
    if (const Result<void> painted = drawing.ground(*ground); !painted) return painted;
  }
  drawing.title();
  drawing.edges();
  drawing.labels();
  drawing.robots(robots);
  canvas->scale_bar();
  drawing.legend(names);
  return canvas->finish();
}

}  // namespace weft::cli
