#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "clients/evaluate/study_file.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Returns of which study a file of rows is, by `from` of its "study"; none: no such file. corrupt: it is none.
template <class OfStudy, class From>
Result<std::optional<OfStudy>> study_in(const std::filesystem::path& file, From&& from) {
  std::optional<OfStudy> study;
  const Result<bool> read =
      read_document(file, [&](const nlohmann::json& document) { study = from(document.at("study")); });
  if (!read) return fail(read.error());
  return study;
}

}  // namespace weft::evaluate::floor
