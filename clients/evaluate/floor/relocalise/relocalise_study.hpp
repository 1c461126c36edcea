#pragma once
#include <cstddef>

#include "clients/evaluate/floor/subject.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// As of any study of floors, but for the line: `metres` of network in a hall that is made for it.
struct RelocaliseOptions : FloorOptions {
  std::size_t trials = 1000;  ///< of each floor, light and seed
};

namespace floor {

/// For each floor and seed a network is taught, and for each light another robot is put down in it `trials` times.
/// What the folder holds already is kept, trial by trial. At the end prints the table and writes relocalise.csv,
/// relocalise.json and a picture. Errors as of study_floor; refused: a wrong place was believed.
Result<Ended> study_relocalisation(const RelocaliseOptions& options, const Surroundings& around);

}  // namespace floor
}  // namespace weft::evaluate
