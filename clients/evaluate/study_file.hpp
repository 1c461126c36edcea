#pragma once
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/result.hpp"

/// Reads and writes the JSON files that studies keep their rows in, and are resumed from.
namespace weft::evaluate {

using TakeDocument = std::function<void(const nlohmann::json& document)>;

/// Gives a file's document to `take`, which may throw nlohmann::json::exception. False: there is no such file.
/// corrupt: it is no JSON, or `take` has thrown.
Result<bool> read_document(const std::filesystem::path& file, const TakeDocument& take);

/// Reads a document whose "study" equals `study`; without a file, `take` is not called. conflict: it belongs to
/// another study, and the message says in which keys; corrupt: as above. `what` names the contents, such as "rows".
Result<void> read_rows_of(const std::filesystem::path& file, const nlohmann::json& study, const std::string& what,
                          const TakeDocument& take);

/// Writes DIR/series/NAME.json, whole or not at all: what pictures show and no other file of the study has.
/// unavailable: names the file.
Result<void> write_series(const std::filesystem::path& folder, const std::string& name,
                          const nlohmann::json& document);

/// Returns the number; NaN of null, which is what NaN is written as.
double number_from(const nlohmann::json& number);

}  // namespace weft::evaluate
