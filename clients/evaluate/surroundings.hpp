#pragma once
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

/// Holds the evaluation; here: what every study is told and gives back.
namespace weft::evaluate {

struct Seeds {
  std::uint64_t first = 1;
  std::uint64_t last = 1;  ///< included
};
std::string words_of(Seeds seeds);

struct Surroundings {
  std::ostream& out;       ///< the table
  std::ostream& progress;  ///< a line a row
  std::function<double()> steady_s;
  std::function<bool()> asked_to_stop;
};

/// Tells how a study ended. `missed`: all was measured and written, but a promise does not hold, as the table says.
enum class Ended { complete, stopped, missed };

/// Counts the rows that there are to measure, and tells how fast it goes.
class RowsMeasured {
 public:
  RowsMeasured(std::size_t all, std::size_t kept, const Surroundings& around);
  /// Reports that one more row is there.
  void row(const std::string& what);

 private:
  std::size_t all_, kept_, measured_ = 0;
  const Surroundings& around_;
  double began_s_;
};

}  // namespace weft::evaluate
