#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "clients/evaluate/surroundings.hpp"
#include "clients/evaluate/topometric/score.hpp"

namespace weft::evaluate::topometric {

/// Bounds one number of one trial (docs/topometric-study.md).
struct Bound {
  enum class Sense : std::uint8_t {
    at_most,       ///< the median over the seeds, and the worst seed
    at_least,      ///< likewise
    between,       ///< each seed lies from `median` to `worst`
    mean_at_least  ///< the mean over the seeds, `median`
  };
  const char* row = "";  ///< of the acceptance table
  const char* measure = "";
  const char* unit = "";
  const char* paper = "";  ///< Dayoub et al.'s
  const char* trial = "";
  const char* value = "";  ///< its name
  Sense sense = Sense::at_most;
  double median = 0.0;
  double worst = 0.0;  ///< not a number: the worst is not bounded
  int digits = 2;
};
const std::vector<Bound>& bounds();

enum class Verdict : std::uint8_t { met, missed, not_measured };
const char* to_string(Verdict verdict);

/// Holds what came of a bound.
struct Judged {
  const Bound* bound = nullptr;
  std::size_t seeds = 0;
  double median = Score::kNothing;
  double worst = Score::kNothing;
  Verdict verdict = Verdict::not_measured;
};

/// Judges what those seeds have come to. `by_worst`: the median too is only held to what is asked of the worst seed,
/// as in a quick study.
std::vector<Judged> judge(const Rows& rows, Seeds seeds, bool by_worst);

/// Returns whether one that was measured does not hold.
bool is_any_missed(const std::vector<Judged>& all);

/// Returns the table: what is asked, what came of it.
std::string table_of(const std::vector<Judged>& all);

}  // namespace weft::evaluate::topometric
