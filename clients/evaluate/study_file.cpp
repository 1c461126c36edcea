#include "clients/evaluate/study_file.hpp"

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "clients/evaluate/files.hpp"

namespace weft::evaluate {

Result<bool> read_document(const std::filesystem::path& file, const TakeDocument& take) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return false;
  try {
    take(nlohmann::json::parse(in));
  } catch (const nlohmann::json::exception& problem) {
    return fail(ErrorCode::corrupt, file.string() + ": not what weft-evaluate wrote (" + problem.what() +
                                        "); give another --out, or remove the file");
  }
  return true;
}

Result<void> read_rows_of(const std::filesystem::path& file, const nlohmann::json& study, const std::string& what,
                          const TakeDocument& take) {
  std::string differs;
  const Result<bool> read = read_document(file, [&](const nlohmann::json& document) {
    differs = difference(document.at("study"), study);
    if (differs.empty()) take(document);
  });
  if (!read) return fail(read.error());
  if (differs.empty()) return {};
  return fail(ErrorCode::conflict, file.string() + ": holds the " + what + " of another study (other " + differs +
                                       "); give another --out, or remove the file");
}

Result<void> write_series(const std::filesystem::path& folder, const std::string& name,
                          const nlohmann::json& document) {
  const std::filesystem::path series = folder / "series";
  if (const Result<void> made = make_folder(series); !made) return made;
  return write_text(series / (name + ".json"), document.dump() + "\n");
}

double number_from(const nlohmann::json& number) {
  return number.is_null() ? std::numeric_limits<double>::quiet_NaN() : number.get<double>();
}

}  // namespace weft::evaluate
