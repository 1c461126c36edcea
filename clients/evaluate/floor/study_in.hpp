#pragma once
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Of which study a file of rows is, by `from` of its "study"; none: no such file. corrupt: it is none.
template <class OfStudy, class From>
Result<std::optional<OfStudy>> study_in(const std::filesystem::path& file, From&& from) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::optional<OfStudy>();
  try {
    return std::optional<OfStudy>(from(nlohmann::json::parse(in).at("study")));
  } catch (const nlohmann::json::exception& problem) {
    return fail(ErrorCode::corrupt, file.string() + ": not what weft-evaluate wrote (" + problem.what() +
                                        "); give another --out, or remove the file");
  }
}

}  // namespace weft::evaluate::floor
