#include "clients/evaluate/truth.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace weft::evaluate {

Result<std::map<std::uint64_t, TrueMoment>> read_truth(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return fail(ErrorCode::unavailable, file.string() + ": the truth that was to be written here is missing");
  std::map<std::uint64_t, TrueMoment> truth;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    try {
      const auto row = nlohmann::json::parse(line);
      truth[row.at("frame").get<std::uint64_t>()] = {
          row.at("t").get<double>(),
          {row.at("x").get<double>(), row.at("y").get<double>(), row.at("heading").get<double>()},
          row.contains("touch") ? std::optional(row.at("touch").get<std::string>()) : std::nullopt};
    } catch (const nlohmann::json::exception& problem) {
      return fail(ErrorCode::corrupt, file.string() + ":" + std::to_string(number) + ": " + problem.what());
    }
  }
  return truth;
}

}  // namespace weft::evaluate
