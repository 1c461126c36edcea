#pragma once
#include <cstddef>
#include <vector>

#include "agents/methods/method.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Holds what refining changes of a run, as the server is to have it.
struct RunAmendments {
  std::vector<AmendedEdge> edges;
  std::vector<AmendedPlace<Bytes>> places;
};

/// Says how far a refinement is.
struct RefineProgress {
  std::size_t done = 0;  ///< pieces
  std::size_t of = 0;    ///< at most; 0: not begun
  bool operator==(const RefineProgress&) const = default;
};

/// Refines one taught run by the method that it was taught with, whose type ends here. Holds the draft: the run's
/// places, edges and contents as they were taught. Pure. The navigator that made it outlives it.
class RunRefiner {
 public:
  virtual ~RunRefiner() = default;
  /// Adds the next place of the run. Errors of the content: it is none of the method's.
  virtual Result<void> add(const Kept& kept) = 0;
  /// Does one piece, the first of which begins; nothing is added any more. Returns whether there are more.
  virtual bool piece() = 0;
  virtual RefineProgress progress() const = 0;
  /// Returns what is to be amended, once; when no pieces are left.
  virtual RunAmendments amendments() = 0;
};

}  // namespace weft::agents
