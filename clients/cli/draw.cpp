#include "clients/cli/draw.hpp"

#include <algorithm>

#include "clients/cli/paint_legend.hpp"
#include "clients/cli/paint_robots.hpp"
#include "clients/cli/paint_sheet.hpp"
#include "clients/cli/plan_paint.hpp"
#include "clients/cli/run_colour.hpp"

namespace weft::cli {
namespace {

class Drawing {
 public:
  Drawing(drawing::Canvas& canvas, const Sheet& sheet, const Subject& subject)
      : canvas_(canvas), sheet_(sheet), subject_(subject) {}

  Result<void> ground(const Ground& ground) {
    const Point origin = sheet_(Pose2{});
    cairo_matrix_t sheet_from_plan{};
    cairo_matrix_init(&sheet_from_plan, sheet_.scale, 0.0, 0.0, -sheet_.scale, origin.x, origin.y);
    return paint(canvas_.pen(), ground.plan, sheet_from_plan);
  }

  void held() {
    constexpr double least = 14.0;
    for (const RobotMark& robot : robots()) {
      const double wide = std::max(least, 2.0 * robot.radius_m * sheet_.scale);
      paint_held(canvas_, points_of(robot.held), wide, robot.is_held_whole);
    }
  }

  void ahead() {
    for (const RobotMark& robot : robots()) {
      if (robot.ahead.empty()) continue;
      const std::vector<Point> points = points_of(robot.ahead);
      paint_ahead(canvas_, points);
      paint_goal(canvas_, points.back());
    }
  }

  void network() {
    const Window& network = subject_.network;
    for (const auto& [id, edge] : network.edges) {
      if (edge.origin == Origin::stitch) continue;
      canvas_.stroke(at(id.a), at(id.b), run_colour(id.a.experience), {kThickRun, edge.origin == Origin::blind});
    }
    for (const auto& [id, place] : network.places) canvas_.dot(at(id), kPlaceRadius, run_colour(id.experience));
    for (const auto& [id, edge] : network.edges) {
      if (edge.origin != Origin::stitch) continue;
      canvas_.stroke(at(id.a), at(id.b), kStitch, {edge.drivable == Drivable::none ? kThinStitch : kThickStitch});
    }
  }

  void labelled_places() {
    for (const auto& [label, place] : subject_.network.labels) {
      if (subject_.layout.drawing_from_place.contains(place)) paint_ring(canvas_, at(place), kInk);
    }
  }

  void robot_arrows() {
    for (const RobotMark& robot : robots()) {
      if (!robot.drawing_from_robot.has_value()) continue;
      const Pose2& pose = *robot.drawing_from_robot;
      paint_robot(canvas_, sheet_(pose), pose.heading, robot.look);
    }
  }

 private:
  Point at(const PlaceId& id) const { return sheet_(subject_.layout.drawing_from_place.at(id)); }

  std::vector<Point> points_of(const std::vector<PlaceId>& places) const {
    std::vector<Point> points;
    for (const PlaceId& place : places) points.push_back(at(place));
    return points;
  }

  const std::vector<RobotMark>& robots() const {
    static const std::vector<RobotMark> none;
    return subject_.robots.has_value() ? subject_.robots->drawn : none;
  }

  drawing::Canvas& canvas_;
  const Sheet& sheet_;
  const Subject& subject_;
};

}  // namespace

Result<void> draw(const Subject& subject, const std::string& file) {
  const Picture picture = compose(subject, text_widths());
  const Sheet& sheet = picture.sheet;
  Result<drawing::Canvas> canvas = drawing::Canvas::make(file, sheet.width, sheet.height);
  if (!canvas) return fail(canvas.error());
  Drawing drawing(*canvas, sheet, subject);
  if (subject.ground.has_value()) {
    if (const Result<void> painted = drawing.ground(*subject.ground); !painted) return painted;
  }
  paint_head(*canvas, sheet, picture.title, picture.detail);
  drawing.held();
  drawing.network();
  drawing.ahead();
  drawing.labelled_places();
  drawing.robot_arrows();
  paint_tags(*canvas, picture.tags);
  paint_legend(*canvas, picture.legend, picture.legend_layout, sheet.legend_top);
  return canvas->finish();
}

}  // namespace weft::cli
