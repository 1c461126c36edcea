#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct RegisterOptions {
  std::filesystem::path a;      ///< cloud that stays
  std::filesystem::path b;      ///< cloud that is moved to it
  std::filesystem::path truth;  ///< a_from_b as a 4 x 4 matrix; empty: nobody knows
  std::string guess;            ///< X,Y,Z,HEADING; empty: where they are
  bool json = false;            ///< one line instead of the table
};

namespace registration {

/// Registers two recorded clouds from a guess by our NDT, and by PCL's GICP and NDT beside it. Prints a row each, as
/// a table or one line of JSON: how far from the truth, or from GICP's answer where there is none, processor time,
/// and whether that is within the bounds: 0.02 m and 0.4 degrees of the truth, or 0.03 m of GICP. Errors of the
/// files.
Result<Ended> study_pair(const RegisterOptions& options, const Surroundings& around,
                         const std::function<double()>& processor_s);

}  // namespace registration
}  // namespace weft::evaluate
