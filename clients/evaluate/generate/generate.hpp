#pragma once
#include <filesystem>
#include <functional>
#include <ostream>

#include "clients/evaluate/generate/site_generator.hpp"
#include "core/result.hpp"
#include "storage/map_store.hpp"

namespace weft::evaluate {

struct Generated {
  std::uint64_t places = 0;   ///< of the site, in the store now
  std::uint64_t written = 0;  ///< of them by this call
  bool is_complete = false;   ///< false: stopped; the same plan goes on from there
};

/// Holds what a generation needs of its surroundings.
struct GenerationWatch {
  std::ostream& progress;  ///< a line every two seconds: count, rate, remaining time
  std::function<double()> steady_s;
  std::function<bool()> asked_to_stop;  ///< asked at every batch
};

/// Brings the plan's site into a store that has been opened, batch by batch with its contents; what is there already
/// is skipped. conflict: the store holds something else under an id of this site, or labels elsewhere; otherwise what
/// the store says.
Result<Generated> generate_site(storage::MapStore& store, const storage::Stored& stored, const SitePlan& plan,
                                const GenerationWatch& watch);

}  // namespace weft::evaluate
