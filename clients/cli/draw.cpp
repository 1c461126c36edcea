#include "clients/cli/draw.hpp"

#include <algorithm>

#include "clients/cli/canvas.hpp"
#include "clients/cli/paint_legend.hpp"
#include "clients/cli/paint_robots.hpp"
#include "clients/cli/plan_paint.hpp"
#include "clients/cli/run_colour.hpp"

namespace weft::cli {
namespace {

class Drawing {
 public:
  Drawing(Canvas& canvas, const Subject& subject) : canvas_(canvas), subject_(subject) {}

  Result<void> ground(const Ground& ground) {
    const Sheet& sheet = canvas_.sheet();
    const Point origin = sheet(Pose2{});
    cairo_matrix_t sheet_from_plan{};
    cairo_matrix_init(&sheet_from_plan, sheet.scale, 0.0, 0.0, -sheet.scale, origin.x, origin.y);
    return paint(canvas_.pen(), ground.plan, sheet_from_plan);
  }

  void held() {
    constexpr double least = 14.0;
    for (const RobotMark& robot : robots()) {
      const double wide = std::max(least, 2.0 * robot.radius_m * canvas_.sheet().scale);
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
      canvas_.stroke(at(id.a), at(id.b), run_colour(id.a.experience), kThickRun, edge.origin == Origin::blind);
    }
    for (const auto& [id, place] : network.places) canvas_.dot(at(id), kPlaceRadius, run_colour(id.experience));
    for (const auto& [id, edge] : network.edges) {
      if (edge.origin != Origin::stitch) continue;
      canvas_.stroke(at(id.a), at(id.b), kStitch, edge.drivable == Drivable::none ? kThinStitch : kThickStitch,
                     false);
    }
  }

  void labelled_places() {
    for (const auto& [label, place] : subject_.network.labels) {
      if (subject_.layout.drawing_from_place.contains(place)) canvas_.ring(at(place), kInk);
    }
  }

  void robot_arrows() {
    for (const RobotMark& robot : robots()) {
      if (!robot.drawing_from_robot.has_value()) continue;
      const Pose2& pose = *robot.drawing_from_robot;
      paint_robot(canvas_, canvas_.sheet()(pose), pose.heading, robot.look);
    }
  }

 private:
  Point at(const PlaceId& id) const { return canvas_.sheet()(subject_.layout.drawing_from_place.at(id)); }

  std::vector<Point> points_of(const std::vector<PlaceId>& places) const {
    std::vector<Point> points;
    for (const PlaceId& place : places) points.push_back(at(place));
    return points;
  }

  const std::vector<RobotMark>& robots() const {
    static const std::vector<RobotMark> none;
    return subject_.robots.has_value() ? subject_.robots->drawn : none;
  }

  Canvas& canvas_;
  const Subject& subject_;
};

}  // namespace

Result<void> draw(const Subject& subject, const std::string& file) {
  const Picture picture = compose(subject, text_widths());
  Result<Canvas> canvas = Canvas::make(file, picture.sheet);
  if (!canvas) return fail(canvas.error());
  Drawing drawing(*canvas, subject);
  if (subject.ground.has_value()) {
    if (const Result<void> painted = drawing.ground(*subject.ground); !painted) return painted;
  }
  canvas->head(picture.title, picture.detail);
  drawing.held();
  drawing.network();
  drawing.ahead();
  drawing.labelled_places();
  drawing.robot_arrows();
  canvas->tags(picture.tags);
  paint_legend(*canvas, picture.legend, picture.legend_layout);
  return canvas->finish();
}

}  // namespace weft::cli
