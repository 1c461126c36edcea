#pragma once
#include <cstddef>

#include "clients/evaluate/floor/subject.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Holds what any study of floors is asked for, but for the line: `metres` of network in a hall made for it.
struct RelocaliseOptions : FloorOptions {
  std::size_t trials = 1000;  ///< of each floor, light and seed
};

namespace floor {

/// Studies how robots find themselves without a seed: for each floor and seed a network is taught; for each light
/// another robot is put down in it `trials` times. Keeps what the folder holds, trial by trial. Prints a table,
/// writes relocalise.csv, relocalise.json, a picture. Errors as of study_floor; refused: a wrong place was believed.
Result<Ended> study_relocalisation(const RelocaliseOptions& options, const Surroundings& around);

}  // namespace floor
}  // namespace weft::evaluate
