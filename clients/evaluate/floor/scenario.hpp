#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Holds the site in which everything is driven, before a kind of floor is laid in it.
struct Stage {
  agents::sim::Site site;
  std::vector<agents::SitePoint> line;
  std::optional<std::string> floors_dir;  ///< photographs: then a kind is one of them
  std::filesystem::path scratch;          ///< a file for the truth; made and removed
  std::function<bool()> asked_to_stop;
};

/// Returns the photographs by name, which is the file's without ending. not_found: there is none, or no such folder.
Result<std::vector<std::string>> photographs_in(const std::filesystem::path& folder);
/// Returns the light and wear that can have changed between teaching and repeating; the first is "same".
const std::vector<std::string>& lights();
/// Returns whether it looks the same in many places: there a refusal to localise is right.
bool repeats_itself(const std::string& kind);
/// Returns whether such a floor has much to see; the bounds of others are wider.
bool is_textured(const std::string& kind);
/// Returns whether odometry's covariance was set by that floor (docs/decisions/024): how often it holds there says
/// nothing of others.
bool was_set_by(const std::string& kind);

/// Makes the drives of one kind of floor and one seed, with its own patch of floor, wear, calibration, noise, wander.
class Scenario {
 public:
  /// Lays a kind of floor in the site. invalid: no such kind.
  static Result<Scenario> make(const Stage& stage, const std::string& kind, std::uint64_t seed);

  /// Describes the drive of the robot that is taught.
  Drive first() const;
  /// Describes the same one's drive to calibrate its mount before, on the same floor; and what it is led along.
  Drive for_calibration() const;
  std::vector<agents::SitePoint> calibration_line() const;
  /// Describes the same one's drive with its mount off by 5 mm and 0.5 degrees.
  Drive with_wrong_mount() const;
  /// Describes a fast drive: 1.5 m/s, 15 images a second, 10 ms of exposure; and what the robot is led along.
  Drive fast() const;
  std::vector<agents::SitePoint> fast_line() const;
  /// Describes the first drive with so many images a second instead of the site's.
  Drive at_rate(double fps) const;
  /// Describes the drive of another robot, with other wear and calibration error, on another day; it starts a hand's
  /// breadth beside the first. invalid: no such light.
  Result<Drive> second(const std::string& light) const;

  /// Describes the drive of a third robot, from where the second part of the line begins, on a third day.
  Drive other_on_second_part() const;

  const std::vector<agents::SitePoint>& line() const { return stage_.line; }
  /// Returns the line's beginning, at most so much of it.
  std::vector<agents::SitePoint> line_beginning(double metres) const;
  /// Returns the line's first 60 percent; below, its last 55.
  std::vector<agents::SitePoint> first_part() const;
  std::vector<agents::SitePoint> second_part() const;
  double camera_height_m() const { return stage_.site.camera.height_m; }

 private:
  Scenario(Stage stage, std::uint64_t seed) : stage_(std::move(stage)), seed_(seed) {}
  Drive drive_in(agents::sim::Site site, std::uint64_t day) const;

  Stage stage_;
  std::uint64_t seed_;
};

double length_of(const std::vector<agents::SitePoint>& line);

/// Returns the line from so many metres on to so many.
std::vector<agents::SitePoint> stretch(const std::vector<agents::SitePoint>& line, double from_m, double to_m);

/// Returns the longest straight part of a line: pieces that turn by less than 5 degrees against its beginning.
std::vector<agents::SitePoint> longest_straight(const std::vector<agents::SitePoint>& line);

}  // namespace weft::evaluate::floor
