#include <algorithm>

#include "clients/cli/picture.hpp"
#include "clients/cli/run_colour.hpp"

namespace weft::cli {
namespace {

/// Returns the poses that must be on the sheet.
std::vector<Pose2> outline(const Subject& subject) {
  std::vector<Pose2> poses;
  for (const auto& [id, pose] : subject.layout.drawing_from_place) poses.push_back(pose);
  if (subject.ground.has_value()) {
    for (const Pose2& corner : corners_of(subject.ground->plan)) poses.push_back(corner);
  }
  if (subject.robots.has_value()) {
    for (const RobotMark& robot : subject.robots->drawn) {
      if (robot.drawing_from_robot.has_value()) poses.push_back(*robot.drawing_from_robot);
    }
  }
  return poses;
}

std::string detail_of(const Subject& subject, std::size_t runs) {
  const Window& network = subject.network;
  std::size_t stitches = 0;
  for (const auto& [id, edge] : network.edges) stitches += edge.origin == Origin::stitch ? 1 : 0;
  std::string detail =
      how_many(runs, "run") + ", " + how_many(network.places.size(), "place") + ", " + how_many(stitches, "stitch");
  if (subject.layout.islands > 1)
    detail += ", " + std::to_string(subject.layout.islands) + " parts that nothing joins";
  if (subject.ground.has_value()) detail += ", " + subject.ground->caption;
  return detail;
}

/// Makes the tags of robots first, then of labels, then of runs: the earlier is placed nearer to what it names.
class TagMaker {
 public:
  TagMaker(const Subject& subject, const Sheet& sheet, const WidthOf& width)
      : subject_(subject), sheet_(sheet), width_(width) {}

  std::vector<Tag> tags(const std::vector<Run>& runs) const {
    std::vector<Tag> tags;
    if (subject_.robots.has_value()) {
      for (const RobotMark& robot : subject_.robots->drawn) tags.push_back(tag_of(robot));
    }
    std::size_t labels = 0;
    for (const auto& [label, place] : subject_.network.labels) {
      if (!is_drawn(place) || labels++ >= kMostLabels) continue;
      tags.push_back(make_tag(label, at(place), kLabelRadius, width_));
    }
    for (std::size_t i = 0; i < std::min(runs.size(), kMostRunsListed); ++i) {
      if (!is_drawn(runs[i].middle)) continue;
      Tag tag = make_tag(shown_run(runs[i].id, subject_.run_names), at(runs[i].middle), kThickRun, width_);
      tag.frame = run_colour(runs[i].id);
      tags.push_back(std::move(tag));
    }
    return tags;
  }

  std::vector<Box> marks() const {
    std::vector<Box> marks;
    for (const auto& [label, place] : subject_.network.labels) {
      if (is_drawn(place)) marks.push_back(around(at(place), kLabelRadius));
    }
    return marks;
  }

  std::vector<Point> points() const {
    std::vector<Point> points;
    for (const auto& [id, pose] : subject_.layout.drawing_from_place) points.push_back(sheet_(pose));
    return points;
  }

 private:
  bool is_drawn(const PlaceId& place) const { return subject_.layout.drawing_from_place.contains(place); }
  Point at(const PlaceId& place) const { return sheet_(subject_.layout.drawing_from_place.at(place)); }

  Tag tag_of(const RobotMark& robot) const {
    const bool stands = robot.drawing_from_robot.has_value();
    Tag tag = make_tag(robot.words, stands ? sheet_(*robot.drawing_from_robot) : at(robot.held.front()),
                       stands ? kRobotRadius : kLabelRadius, width_);
    tag.frame = kInk;
    return tag;
  }

  const Subject& subject_;
  const Sheet& sheet_;
  const WidthOf& width_;
};

}  // namespace

Picture compose(const Subject& subject, const WidthOf& width) {
  const std::vector<Run> runs = runs_of(subject.network);
  Picture picture;
  picture.sheet = fit(outline(subject));
  const double wide = picture.sheet.width - 2.0 * kSheetMargin;
  picture.title = "Weft network, revision " + std::to_string(subject.network.revision.value);
  picture.detail = elided(detail_of(subject, runs.size()), kDetailWords, wide, width);
  picture.legend = legend_of(subject, runs);
  for (std::vector<LegendLine>* const lines : {&picture.legend.runs, &picture.legend.marks}) {
    for (LegendLine& line : *lines) line.words = elided(line.words, kLegendWords, wide - kLegendSample, width);
  }
  picture.legend_layout = lay_legend(picture.legend, wide, width);
  const TagMaker maker(subject, picture.sheet, width);
  picture.tags = maker.tags(runs);
  place(picture.tags, maker.marks(), maker.points(), picture.sheet, picture.legend_layout.height);
  return picture;
}

}  // namespace weft::cli
