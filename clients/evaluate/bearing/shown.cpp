#include "clients/evaluate/bearing/shown.hpp"

#include <nlohmann/json.hpp>

#include "clients/evaluate/files.hpp"

namespace weft::evaluate::bearing {
namespace {

std::array<double, 2> point_of(const Pose2& pose) {
  return {pose.x, pose.y};
}

Shown::Points points_of(const std::vector<ErrorAt>& errors) {
  Shown::Points points;
  for (const ErrorAt& error : errors) points.push_back({error.along_m, error.error_m});
  return points;
}

}  // namespace

Shown shown_of(const Course& course, const Repeated& repeated, const std::vector<ErrorAt>& first_loop,
               const std::vector<ErrorAt>& model) {
  Shown shown;
  for (const Pose2& pose : course.site_from_place) shown.taught.push_back(point_of(pose));
  const std::vector<Deviation>& ends = repeated.after_loop;
  const double first_ends_m = ends.empty() ? repeated.along.back().driven_m : ends.front().driven_m;
  const double last_begins_m = ends.size() < 2 ? repeated.along.back().driven_m : ends[ends.size() - 2].driven_m;
  for (const Deviation& deviation : repeated.along) {
    if (deviation.driven_m <= first_ends_m) shown.first.push_back(point_of(deviation.site_from_robot));
    if (deviation.driven_m >= last_begins_m) shown.last.push_back(point_of(deviation.site_from_robot));
  }
  shown.error = points_of(first_loop);
  shown.model = points_of(model);
  return shown;
}

Result<void> write_shown(const std::filesystem::path& folder, const std::string& trial, const Shown& shown) {
  if (const Result<void> made = make_folder(folder); !made) return fail(made.error());
  const nlohmann::json document = {{"taught", shown.taught},
                                   {"first", shown.first},
                                   {"last", shown.last},
                                   {"error", shown.error},
                                   {"model", shown.model}};
  return write_text(folder / (trial + ".json"), document.dump() + "\n");
}

}  // namespace weft::evaluate::bearing
