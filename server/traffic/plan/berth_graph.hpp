#pragma once
#include <cstdint>
#include <limits>
#include <vector>

namespace weft::server {

/// Numbers a berth: a place of the network at which one robot can stand.
using Berth = std::uint32_t;
inline constexpr Berth kNoBerth = std::numeric_limits<Berth>::max();

/// Describes a drive from one berth to the next.
struct BerthArc {
  Berth to = kNoBerth;
  double length_m = 0.0;
  /// Numbers its middle, where nobody stands: two drives that come by each other touch the one's or the other's.
  Berth middle = kNoBerth;
  /// Lists the berths that are touched on the way beyond those that a robot keeps free where it sets off: `to` and
  /// those beside it among them, and not where it sets off; and the middles of other drives, as far as they are
  /// known. Sorted.
  std::vector<Berth> touches;
};

/// Describes the network as a plan sees it: where robots can stand, and between which of these they can drive. Berths
/// and drives may be made when they are first asked for: numbers may grow with every call, references stay valid.
class BerthGraph {
 public:
  BerthGraph() = default;
  BerthGraph(const BerthGraph&) = delete;
  BerthGraph& operator=(const BerthGraph&) = delete;
  virtual ~BerthGraph() = default;

  /// Returns the drives from there on, in a fixed order. `methods` numbers the set of methods that the robot drives
  /// with.
  virtual const std::vector<BerthArc>& next(Berth from, std::uint32_t methods) = 0;
  struct Before {
    Berth from = kNoBerth;
    double length_m = 0.0;
  };
  /// Returns from where one can drive there.
  virtual const std::vector<Before>& before(Berth to, std::uint32_t methods) = 0;
  /// Returns the berths at which nobody can stand while a robot stands there; not the berth itself. Sorted.
  virtual const std::vector<Berth>& beside(Berth berth) = 0;
  /// Returns whether robots may stop there on their way; else it is a berth only for robots that stand there or want
  /// to.
  virtual bool is_cut(Berth berth) const = 0;
  /// Returns how many berths have numbers.
  virtual std::size_t size() const = 0;
  /// Counts what was looked up in the map for all that, in units of about one search over some berths.
  virtual std::uint64_t looked_up() const { return 0; }
};

}  // namespace weft::server
