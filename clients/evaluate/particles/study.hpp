#pragma once
#include <filesystem>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct ParticlesOptions {
  std::filesystem::path log;  ///< CARMEN, corrected, packed by gzip or not
  Seeds seeds{1, 3};
  double alpha = 0.2;        ///< of AMCL's motion model, all four
  bool is_anywhere = false;  ///< begins anywhere
  std::filesystem::path out;
  bool json = false;  ///< one line instead of the table
};

namespace particles {

/// Studies how well the particle filter locates a recorded laser: a grid of the scans with even numbers, those with
/// odd ones located in it (docs/results/particles.md). Prints a table, or one line of JSON: study, rows, asked (null:
/// nothing is), is_met. Writes particles.json, .csv and .png, of a
/// study that begins anywhere particles-global.*. Goes on where it was stopped, seed by seed. Errors of the log, and
/// of the folder.
Result<Ended> study_particles(const ParticlesOptions& options, const Surroundings& around);

}  // namespace particles
}  // namespace weft::evaluate
