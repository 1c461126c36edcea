#pragma once
#include <filesystem>

#include "agents/perception/upright_features.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct HeadingOptions {
  std::filesystem::path folder;  ///< in one of GRIEF's layouts
  agents::Description feature = agents::Description::gradients;
  bool json = false;                                         ///< one line of JSON instead of the table
  int features = agents::UprightConfig{}.count;              ///< of an image at most
  double cell_widths = agents::UprightConfig{}.cell_widths;  ///< of the image, of a cell of those that describe one
};

namespace heading {

/// Studies how well the most frequent shift of features tells the heading between images of one place. Prints a row a
/// place: pairs, how many are right within 35 pixels, median error, how many were refused. Errors of the folder;
/// corrupt: an image, by name.
Result<Ended> study_heading(const HeadingOptions& options, const Surroundings& around);

}  // namespace heading
}  // namespace weft::evaluate
