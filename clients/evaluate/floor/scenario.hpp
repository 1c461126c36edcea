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

/// The site in which everything is driven, before a kind of floor is laid in it.
struct Stage {
  agents::sim::Site site;
  std::vector<agents::SitePoint> line;
  std::optional<std::string> floors_dir;  ///< photographs: then a kind is one of them
  std::filesystem::path scratch;          ///< a file for the truth; made and removed
  std::function<bool()> asked_to_stop;
};

/// Photographs by name, which is the file's without ending. not_found: there is none, or no such folder.
Result<std::vector<std::string>> photographs_in(const std::filesystem::path& folder);
/// Light and wear that can have changed between teaching and repeating; the first is "same".
const std::vector<std::string>& lights();
/// A floor of which a refusal to localise is right: it looks the same in many places.
bool repeats_itself(const std::string& kind);
/// A floor with much to see; the bounds of others are wider.
bool is_textured(const std::string& kind);
/// A floor by which odometry's covariance was set (docs/decisions/024): how often it holds there says nothing of
/// others.
bool was_set_by(const std::string& kind);

/// One kind of floor and one seed: another patch of that floor, other wear, calibration, noise and wander.
class Scenario {
 public:
  /// invalid: no such kind.
  static Result<Scenario> make(const Stage& stage, const std::string& kind, std::uint64_t seed);

  /// The robot that is taught.
  Drive first() const;
  /// The same one where its mount is calibrated before: on the same floor; and what it is led along.
  Drive for_calibration() const;
  std::vector<agents::SitePoint> calibration_line() const;
  /// The same one with its mount off by 5 mm and 0.5 degrees.
  Drive with_wrong_mount() const;
  /// A fast one: 1.5 m/s, 15 images a second, 10 ms of exposure; and what it is led along.
  Drive fast() const;
  std::vector<agents::SitePoint> fast_line() const;
  /// With so many images a second instead of the site's.
  Drive at_rate(double fps) const;
  /// Another robot, other wear and calibration error, on another day; started a hand's breadth beside the first.
  /// invalid: no such light.
  Result<Drive> second(const std::string& light) const;

  /// A third robot, where the second part of the line begins; on a third day.
  Drive other_on_second_part() const;

  const std::vector<agents::SitePoint>& line() const { return stage_.line; }
  /// At most so much of it.
  std::vector<agents::SitePoint> line_beginning(double metres) const;
  /// Its first 60 and its last 55 percent.
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

/// From so many metres on to so many.
std::vector<agents::SitePoint> stretch(const std::vector<agents::SitePoint>& line, double from_m, double to_m);

/// The longest straight part of a line: pieces that turn by less than 5 degrees against its beginning.
std::vector<agents::SitePoint> longest_straight(const std::vector<agents::SitePoint>& line);

}  // namespace weft::evaluate::floor
