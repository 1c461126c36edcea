#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "clients/evaluate/surroundings.hpp"

namespace weft::evaluate {

/// Names the program that draws pictures of studies, and what runs it.
struct Drawer {
  std::filesystem::path python = "/usr/bin/python3";  ///< Debian's, which python3-matplotlib belongs to
  std::filesystem::path script = script_of_this_build();

  static std::filesystem::path script_of_this_build();
};

/// Draws the pictures of a study, such as "floor", from the files in its folder, and returns their names. Without
/// Python or Matplotlib a warning on `around.progress` says what is missing and how to draw them later; the study
/// goes on, as its rows are there.
std::vector<std::string> draw_pictures(const std::string& study, const std::filesystem::path& folder,
                                       const Surroundings& around, const Drawer& drawer = {});

/// Returns for people what was drawn: "no pictures", the name of the only one, "4 pictures".
std::string words_of(const std::vector<std::string>& pictures);

}  // namespace weft::evaluate
