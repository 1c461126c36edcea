#include "clients/evaluate/bearing/shown.hpp"

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "clients/evaluate/files.hpp"

namespace weft::evaluate::bearing {
namespace {

using charts::Dot;
using nlohmann::json;

constexpr std::array<std::pair<const char*, std::vector<Dot> Shown::*>, 5> kParts = {{{"taught", &Shown::taught},
                                                                                      {"first", &Shown::first},
                                                                                      {"last", &Shown::last},
                                                                                      {"error", &Shown::error},
                                                                                      {"model", &Shown::model}}};

Dot dot_of(const Pose2& pose) {
  return {pose.x, pose.y};
}

std::vector<Dot> dots_of(const std::vector<ErrorAt>& errors) {
  std::vector<Dot> dots;
  for (const ErrorAt& error : errors) dots.push_back({error.along_m, error.error_m});
  return dots;
}

}  // namespace

Shown shown_of(const Course& course, const Repeated& repeated, const std::vector<ErrorAt>& first_loop,
               const std::vector<ErrorAt>& model) {
  Shown shown;
  for (const Pose2& pose : course.site_from_place) shown.taught.push_back(dot_of(pose));
  const std::vector<Deviation>& ends = repeated.after_loop;
  const double first_ends_m = ends.empty() ? repeated.along.back().driven_m : ends.front().driven_m;
  const double last_begins_m = ends.size() < 2 ? repeated.along.back().driven_m : ends[ends.size() - 2].driven_m;
  for (const Deviation& deviation : repeated.along) {
    if (deviation.driven_m <= first_ends_m) shown.first.push_back(dot_of(deviation.site_from_robot));
    if (deviation.driven_m >= last_begins_m) shown.last.push_back(dot_of(deviation.site_from_robot));
  }
  shown.error = dots_of(first_loop);
  shown.model = dots_of(model);
  return shown;
}

Result<void> write_shown(const std::filesystem::path& folder, const std::string& trial, const Shown& shown) {
  if (const Result<void> made = make_folder(folder); !made) return fail(made.error());
  json document;
  for (const auto& [name, part] : kParts) {
    json dots = json::array();
    for (const Dot& dot : shown.*part) dots.push_back({dot.x, dot.y});
    document[name] = std::move(dots);
  }
  return write_text(folder / (trial + ".json"), document.dump() + "\n");
}

std::optional<Shown> read_shown(const std::filesystem::path& folder, const std::string& trial) {
  std::ifstream in(folder / (trial + ".json"), std::ios::binary);
  if (!in) return std::nullopt;
  Shown shown;
  try {
    const json document = json::parse(in);
    for (const auto& [name, part] : kParts) {
      for (const json& dot : document.at(name)) (shown.*part).push_back({dot.at(0), dot.at(1)});
    }
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return shown;
}

}  // namespace weft::evaluate::bearing
