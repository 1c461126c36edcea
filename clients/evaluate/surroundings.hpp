#pragma once
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

/// What every study is told and gives back.
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

/// `missed`: all was measured and written, and something that is promised does not hold; the table says what.
enum class Ended { complete, stopped, missed };

/// Rows there are to measure, and how fast it goes.
class RowsMeasured {
 public:
  RowsMeasured(std::size_t all, std::size_t kept, const Surroundings& around);
  /// One more is there.
  void row(const std::string& what);

 private:
  std::size_t all_, kept_, measured_ = 0;
  const Surroundings& around_;
  double began_s_;
};

}  // namespace weft::evaluate
