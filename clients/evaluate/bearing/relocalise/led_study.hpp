#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct BearingRelocaliseOptions {
  Seeds seeds;
  std::string kind;            ///< one; empty: all
  std::size_t trials = 11;     ///< of each kind, light and seed
  std::filesystem::path site;  ///< whose camera, base and disturbances the robots have
  std::filesystem::path out;   ///< folder; made if it is not there
};

namespace bearing {

/// Studies whether a lost robot tells aisles that look alike from one another. For each kind and seed a hall is
/// taught; for each light another robot is put down in it `trials` times and led on until it believes to know where
/// it is. What the folder holds already is kept, trial by trial. Prints the table, writes relocalise.csv,
/// relocalise.json and a picture; `missed`: a place was taken for another one, or too few found themselves.
/// not_found, invalid: site or kind; conflict: the folder holds another study; unavailable: it cannot be written.
Result<Ended> study_look_alikes(const BearingRelocaliseOptions& options, const Surroundings& around);

}  // namespace bearing
}  // namespace weft::evaluate
