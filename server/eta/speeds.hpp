#pragma once
#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/network/goal.hpp"
#include "core/network/passes.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// Tells how fast robots get on.
struct Pace {
  double speed_m_s = 0.0;     ///< while they drive
  double wait_s_per_m = 0.0;  ///< that they stand for others, on a mean
};

/// Tells what is left of a way.
struct TimeLeft {
  double drive_s = 0.0;
  double wait_s = 0.0;
  double total_s() const { return drive_s + wait_s; }
};

/// Learns how long robots take for the pieces of runs, by the latest passes of each: a run is of one method, so this
/// is by method, too. Waiting is foretold as it was lately, not as it is planned: a plan of everybody's moves ends
/// after a minute, and most of what holds a robot up comes behind that.
class Speeds {
 public:
  explicit Speeds(const std::map<RunPiece, std::vector<Pass>>& stored = {});

  /// Learns of a pass; short ones are added up until they are kShortPass_m long together.
  void add(const RunPiece& piece, const Pass& pass);
  /// Returns the median speed of the piece's passes and the mean of its waits, which counts with that of all pieces
  /// until there is enough of it. A piece without passes has the median and mean of all pieces; before anything was
  /// learned the speed is kDefaultSpeed_m_s.
  Pace pace(const RunPiece& piece) const;
  /// Returns what is left of the route from that index on.
  TimeLeft left(const Route& route, std::size_t at) const;

  /// Returns up to that many pieces that have changed since they were stored, and counts them as stored.
  std::vector<storage::PutPasses> take_unsaved(std::size_t most);
  bool has_unsaved() const { return !unsaved_.empty(); }
  /// Counts these as not stored.
  void put_back(const std::vector<storage::PutPasses>& passes);

  static constexpr double kDefaultSpeed_m_s = 0.5;
  static constexpr double kShortPass_m = 2.0;

 private:
  struct Known {
    std::vector<Pass> passes;
    std::optional<double> speed_m_s;  ///< none: there is no pass that is long enough
    Pass sum;
  };

  static void sum_up(Known& known);
  Pace pace(const RunPiece& piece, const Pace& everywhere) const;
  Pace everywhere() const;

  std::map<RunPiece, Known> known_;
  std::deque<Pass> latest_;  ///< of all pieces
  std::set<RunPiece> unsaved_;
};

/// Returns the value that the share of the values does not exceed; there is one at least.
double quantile(std::vector<double> values, double share);

}  // namespace weft::server
