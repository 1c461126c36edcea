#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/floor/shown.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Says where the runs of one floor are kept, as files of traces.
struct Shelf {
  std::filesystem::path folder;
  std::string stamp;  ///< of the study: runs of another one are not taken for its own
  std::string kind;
  std::uint64_t seed = 1;

  std::filesystem::path file(const std::string& what) const;
  std::optional<Trace> find(const std::string& what) const;
  Result<void> keep(const std::string& what, const Trace& trace) const;
};

inline constexpr const char* kTaughtRun = "taught";

/// Returns all runs that pictures show: from the shelf where they are there, else driven and put there. None:
/// stopped. Errors of the drives and of the shelf.
Result<std::optional<Shown>> shown_of(const Scenario& scenario, const std::string& light, const Shelf& shelf);

/// Returns whether the shelf holds all runs that pictures show.
bool has_shown(const std::string& light, const Shelf& shelf);

}  // namespace weft::evaluate::floor
