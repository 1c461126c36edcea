#include "clients/cli/draw.hpp"

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>

#include "clients/cli/layout.hpp"
#include "clients/cli/plan_paint.hpp"
#include "storage/formats/import.hpp"

namespace weft::cli {
namespace {

constexpr double kWidth = 1600.0;
constexpr double kMargin = 60.0;
constexpr double kTitle = 90.0;   // above the network
constexpr double kFooter = 70.0;  // below it, besides the legend's lines
constexpr double kLine = 26.0;    // of the legend
constexpr double kTallest = 1400.0;

struct Colour {
  double r, g, b;
};
/// Told apart by people who see colours differently (Okabe & Ito).
constexpr std::array<Colour, 7> kColours = {{{0.00, 0.45, 0.70},
                                             {0.84, 0.37, 0.00},
                                             {0.00, 0.62, 0.45},
                                             {0.80, 0.47, 0.65},
                                             {0.90, 0.62, 0.00},
                                             {0.34, 0.71, 0.91},
                                             {0.55, 0.45, 0.20}}};
constexpr Colour kInk = {0.13, 0.15, 0.18};
constexpr Colour kQuiet = {0.50, 0.53, 0.57};
constexpr Colour kStitch = {0.45, 0.20, 0.55};

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Pen = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// From the drawing's metres to the sheet's units; y turned round.
struct Sheet {
  double scale = 1.0;
  double left = 0.0;
  double top = 0.0;
  double height = 0.0;
  Point operator()(const Pose2& pose) const {
    return {kMargin + (pose.x - left) * scale, kTitle + (top - pose.y) * scale};
  }
};

/// What must be on the sheet.
std::vector<Pose2> outline(const Layout& layout, const std::optional<Ground>& ground) {
  std::vector<Pose2> poses;
  for (const auto& [id, pose] : layout.drawing_from_place) poses.push_back(pose);
  if (ground.has_value()) {
    for (const Pose2& corner : corners_of(ground->plan)) poses.push_back(corner);
  }
  return poses;
}

Sheet fit(const std::vector<Pose2>& poses, std::size_t legend_lines) {
  double left = 0.0;
  double right = 1.0;
  double bottom = 0.0;
  double top = 1.0;
  bool first = true;
  for (const Pose2& pose : poses) {
    left = first ? pose.x : std::min(left, pose.x);
    right = first ? pose.x : std::max(right, pose.x);
    bottom = first ? pose.y : std::min(bottom, pose.y);
    top = first ? pose.y : std::max(top, pose.y);
    first = false;
  }
  const double wide = std::max(right - left, 1.0);
  const double tall = std::max(top - bottom, 1.0);
  Sheet sheet;
  sheet.scale = std::min((kWidth - 2.0 * kMargin) / wide, kTallest / tall);
  sheet.left = left - 0.5 * ((kWidth - 2.0 * kMargin) / sheet.scale - wide);
  sheet.top = top;
  sheet.height = kTitle + tall * sheet.scale + kFooter + kLine * static_cast<double>(legend_lines) + kMargin;
  return sheet;
}

class Drawing {
 public:
  Drawing(cairo_t* pen, const Sheet& sheet, const Layout& layout, const Window& network)
      : pen_(pen), sheet_(sheet), layout_(layout), network_(network) {
    for (const auto& [id, place] : network.places) {
      if (colours_.contains(id.experience)) continue;
      colours_.emplace(id.experience, kColours.at(colours_.size() % kColours.size()));
    }
  }

  void paper() {
    cairo_set_source_rgb(pen_, 1.0, 1.0, 1.0);
    cairo_paint(pen_);
    cairo_select_font_face(pen_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_cap(pen_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(pen_, CAIRO_LINE_JOIN_ROUND);
  }

  Result<void> ground(const Ground& ground) {
    const Point origin = sheet_(Pose2{});
    cairo_matrix_t sheet_from_plan{};
    cairo_matrix_init(&sheet_from_plan, sheet_.scale, 0.0, 0.0, -sheet_.scale, origin.x, origin.y);
    caption_ = ", " + ground.caption;
    return paint(pen_, ground.plan, sheet_from_plan);
  }

  void title() {
    std::size_t stitches = 0;
    for (const auto& [id, edge] : network_.edges) stitches += edge.origin == Origin::stitch ? 1 : 0;
    text({kMargin, 46.0}, "Weft network, revision " + std::to_string(network_.revision.value), 24.0, kInk);
    std::string detail = std::to_string(colours_.size()) + " experiences, " + std::to_string(network_.places.size()) +
                         " places, " + std::to_string(stitches) + " stitches";
    if (layout_.islands > 1) detail += ", " + std::to_string(layout_.islands) + " parts that nothing joins";
    detail += caption_;
    text({kMargin, 70.0}, detail, 14.0, kQuiet);
  }

  void edges() {
    for (const auto& [id, edge] : network_.edges) {
      if (edge.origin != Origin::stitch) path(id, colours_.at(id.a.experience), 4.0, edge.origin == Origin::blind);
    }
    for (const auto& [id, place] : network_.places) {
      dot(sheet_(layout_.drawing_from_place.at(id)), 3.2, colours_.at(id.experience));
    }
    for (const auto& [id, edge] : network_.edges) {
      if (edge.origin == Origin::stitch) path(id, kStitch, 1.6, false);
    }
  }

  void labels() {
    for (const auto& [label, place] : network_.labels) {
      const auto found = layout_.drawing_from_place.find(place);
      if (found == layout_.drawing_from_place.end()) continue;
      const Point at = sheet_(found->second);
      dot(at, 8.0, kInk);
      dot(at, 5.0, {1.0, 1.0, 1.0});
      tag(at, label, 15.0, kInk);
    }
  }

  void robots(const std::vector<msg::RobotRow>& rows) {
    for (const msg::RobotRow& row : rows) {
      const auto found = layout_.drawing_from_place.find(row.state.place);
      if (!row.state.place || found == layout_.drawing_from_place.end()) continue;
      robot(found->second * planar(row.state.place_from_robot), row.description.name);
    }
  }

  void scale() {
    double metres = 1.0;
    for (const double step : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0}) {
      if (metres * sheet_.scale < 120.0) metres = step;
    }
    const double y = 62.0;
    const double right = kWidth - kMargin;
    const double left = right - metres * sheet_.scale;
    colour(kInk);
    cairo_set_line_width(pen_, 2.0);
    for (const auto& [x0, y0, x1, y1] : {std::array{left, y, right, y}, std::array{left, y - 6.0, left, y + 6.0},
                                         std::array{right, y - 6.0, right, y + 6.0}}) {
      cairo_move_to(pen_, x0, y0);
      cairo_line_to(pen_, x1, y1);
    }
    cairo_stroke(pen_);
    std::array<char, 32> words{};
    std::snprintf(words.data(), words.size(), "%g m", metres);
    text({0.5 * (left + right) - 0.5 * width(words.data(), 15.0), y - 10.0}, words.data(), 15.0, kInk);
  }

  void legend(const Names& names) {
    double y = sheet_.height - kMargin - kLine * static_cast<double>(legend_lines(network_)) + kLine;
    for (const auto& [id, ink] : colours_) {
      std::uint32_t places = 0;
      std::string taught;
      for (const auto& [place, held] : network_.places) {
        if (place.experience != id) continue;
        if (places++ > 0) continue;
        taught = held.method == formats::kImportedMethod ? "imported" : "taught by " + name_of(names, held.robot);
      }
      sample(y, ink, 5.0);
      text({kMargin + 60.0, y + 5.0}, taught + ": " + std::to_string(places) + " places, experience " + to_string(id),
           15.0, kInk);
      y += kLine;
    }
    sample(y, kStitch, 1.6);
    text({kMargin + 60.0, y + 5.0}, "stitch: the same spot, seen in two runs", 15.0, kInk);
    if (!has_blind(network_)) return;
    y += kLine;
    sample(y, kInk, 4.0, true);
    text({kMargin + 60.0, y + 5.0}, "dashed: joined by odometry alone", 15.0, kInk);
  }

  static std::size_t legend_lines(const Window& network) {
    std::size_t experiences = 0;
    ExperienceId last;
    for (const auto& [id, place] : network.places) {
      experiences += id.experience != last ? 1 : 0;
      last = id.experience;
    }
    return experiences + 1 + (has_blind(network) ? 1 : 0);
  }

  static bool has_blind(const Window& network) {
    return std::any_of(network.edges.begin(), network.edges.end(),
                       [](const auto& entry) { return entry.second.origin == Origin::blind; });
  }

 private:
  void colour(const Colour& ink) { cairo_set_source_rgb(pen_, ink.r, ink.g, ink.b); }

  void path(const EdgeId& id, const Colour& ink, double thick, bool dashed) {
    stroke(sheet_(layout_.drawing_from_place.at(id.a)), sheet_(layout_.drawing_from_place.at(id.b)), ink, thick,
           dashed);
  }

  void stroke(const Point& a, const Point& b, const Colour& ink, double thick, bool dashed) {
    const std::array<double, 2> dashes = {7.0, 7.0};
    colour(ink);
    cairo_set_dash(pen_, dashes.data(), dashed ? 2 : 0, 0.0);
    cairo_set_line_width(pen_, thick);
    cairo_move_to(pen_, a.x, a.y);
    cairo_line_to(pen_, b.x, b.y);
    cairo_stroke(pen_);
    cairo_set_dash(pen_, nullptr, 0, 0.0);
  }

  void dot(const Point& at, double radius, const Colour& ink) {
    colour(ink);
    cairo_arc(pen_, at.x, at.y, radius, 0.0, 2.0 * std::numbers::pi);
    cairo_fill(pen_);
  }

  void robot(const Pose2& drawing_from_robot, const std::string& name) {
    const Point at = sheet_(drawing_from_robot);
    cairo_save(pen_);
    cairo_translate(pen_, at.x, at.y);
    cairo_rotate(pen_, -drawing_from_robot.heading);
    cairo_move_to(pen_, 16.0, 0.0);
    cairo_line_to(pen_, -10.0, 10.0);
    cairo_line_to(pen_, -5.0, 0.0);
    cairo_line_to(pen_, -10.0, -10.0);
    cairo_close_path(pen_);
    cairo_set_source_rgb(pen_, 0.98, 0.80, 0.10);
    cairo_fill_preserve(pen_);
    colour(kInk);
    cairo_set_line_width(pen_, 1.6);
    cairo_stroke(pen_);
    cairo_restore(pen_);
    tag({at.x, at.y + 34.0}, name, 14.0, kInk);
  }

  /// Words beside a point, on a white ground so that lines do not run through them.
  void tag(const Point& at, const std::string& words, double size, const Colour& ink) {
    const double wide = width(words, size);
    const bool fits = at.x + 14.0 + wide < kWidth - 8.0;
    const Point from{fits ? at.x + 12.0 : at.x - 12.0 - wide, at.y - 10.0};
    cairo_set_source_rgba(pen_, 1.0, 1.0, 1.0, 0.85);
    cairo_rectangle(pen_, from.x - 3.0, from.y - size, wide + 6.0, size + 5.0);
    cairo_fill(pen_);
    text(from, words, size, ink);
  }

  void sample(double y, const Colour& ink, double thick, bool dashed = false) {
    stroke({kMargin, y}, {kMargin + 44.0, y}, ink, thick, dashed);
  }

  void text(const Point& at, const std::string& words, double size, const Colour& ink) {
    colour(ink);
    cairo_set_font_size(pen_, size);
    cairo_move_to(pen_, at.x, at.y);
    cairo_show_text(pen_, words.c_str());
  }

  double width(const std::string& words, double size) {
    cairo_text_extents_t extents{};
    cairo_set_font_size(pen_, size);
    cairo_text_extents(pen_, words.c_str(), &extents);
    return extents.x_advance;
  }

  cairo_t* pen_;
  const Sheet& sheet_;
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
  const bool svg = file.ends_with(".svg");
  if (!svg && !file.ends_with(".png")) {
    return fail(ErrorCode::invalid, file + ": give a name that ends in .png or .svg");
  }
  const Sheet sheet = fit(outline(layout, ground), Drawing::legend_lines(network));
  const Surface surface(
      svg ? cairo_svg_surface_create(file.c_str(), kWidth, sheet.height)
          : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kWidth), static_cast<int>(sheet.height)),
      cairo_surface_destroy);
  const Pen pen(cairo_create(surface.get()), cairo_destroy);
  Names names;
  for (const msg::RobotRow& row : robots) names[row.description.header.sender] = row.description.name;
  Drawing drawing(pen.get(), sheet, layout, network);
  drawing.paper();
  if (ground.has_value()) {
    if (const Result<void> painted = drawing.ground(*ground); !painted) return painted;
  }
  drawing.title();
  drawing.edges();
  drawing.labels();
  drawing.robots(robots);
  drawing.scale();
  drawing.legend(names);
  cairo_surface_flush(surface.get());
  if (svg) cairo_surface_finish(surface.get());
  const cairo_status_t status =
      svg ? cairo_surface_status(surface.get()) : cairo_surface_write_to_png(surface.get(), file.c_str());
  if (status != CAIRO_STATUS_SUCCESS) {
    return fail(ErrorCode::exhausted, file + ": " + cairo_status_to_string(status) + "; is the folder there?");
  }
  return {};
}

}  // namespace weft::cli
