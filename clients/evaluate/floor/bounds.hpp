#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clients/evaluate/floor/score.hpp"
#include "clients/evaluate/surroundings.hpp"

namespace weft::evaluate::floor {

/// Bounds what is promised of the method: a number of each run, and how large its median and its worst over the seeds
/// may be.
struct Bound {
  enum class Of {
    mapping,  ///< every kind of floor
    repeat,   ///< every kind and light
    easy,     ///< textured floors in the light they were taught in
    hard      ///< all others
  };
  const char* name = "";
  const char* unit = "";
  const char* paper = "";  ///< Gadd & Newman's
  Of of = Of::mapping;
  double Score::*value = nullptr;
  double median = 0.0;
  double worst = 0.0;
  bool of_refusers = false;  ///< holds for floors too on which a refusal to localise is right
  /// Bounds not the median and the worst seed, but the mean of all lights and seeds together, on the floors by which
  /// nothing was set: it lies from the first number to the second.
  bool is_share = false;
};
/// Bounds from below the seeds by which a share of all seeds together is judged.
inline constexpr std::size_t kSeedsOfAShare = 40;
/// Returns the bounds that `weft-evaluate floor` measures itself.
const std::vector<Bound>& bounds();

/// Names a floor and a part, of which all seeds are taken together.
using GroupKey = std::pair<std::string, std::string>;  // kind, part
std::map<GroupKey, std::vector<const Score*>> grouped(const Rows& rows, Seeds seeds);
std::vector<double> values_of(const std::vector<const Score*>& scores, double Score::*value);

/// Holds one bound on one floor and, of a repeat, under one light.
struct Group {
  std::string kind;
  std::string part;
  std::size_t seeds = 0;
  double metres = 0.0;  ///< over the seeds, mapping or repeats alone
  double median = Score::kNothing;
  double worst = Score::kNothing;
  bool met = false;  ///< false too where there was nothing to measure
};
struct Judged {
  const Bound* bound = nullptr;
  std::vector<Group> groups;
  double median = Score::kNothing;  ///< of the group that is worst; of a share the mean, as `worst`
  double worst = Score::kNothing;
  bool met = false;                 ///< by every group, and there is one
  bool is_judged = true;            ///< false: of a share, by too few seeds, each with one draw of a calibration
  const char* command = "floor";    ///< of weft-evaluate, that measures it
  std::optional<std::size_t> of{};  ///< attempts or trials, where they are counted
};
/// Judges by all of `bounds`, over the seeds that are there.
std::vector<Judged> judge(const Rows& rows, Seeds seeds);

/// Tells whether one that was measured and is judged does not hold.
bool is_any_missed(const std::vector<Judged>& all);

/// Holds median and largest; NaN without values. A value that is none (it could not be measured) is the worst.
struct MedianWorst {
  double median = 0.0;
  double worst = 0.0;
};
MedianWorst median_worst(std::vector<double> values);

/// Returns the mean of those that are numbers; NaN when none is.
double mean_of(const std::vector<double>& values);

}  // namespace weft::evaluate::floor
