#include "clients/evaluate/recorded_truth.hpp"

#include <string>
#include <utility>

#include "clients/evaluate/files.hpp"

namespace weft::evaluate {

Result<std::optional<formats::Trajectory>> recorded_truth(const std::filesystem::path& recording,
                                                          const std::filesystem::path& given) {
  std::filesystem::path file = given;
  for (const char* const usual :
       {"groundtruth_tum.txt", "groundtruth.txt", "mav0/state_groundtruth_estimate0/data.csv"}) {
    if (file.empty() && std::filesystem::is_regular_file(recording / usual)) file = recording / usual;
  }
  if (file.empty()) return std::optional<formats::Trajectory>();
  const Result<std::string> text = read_text(file, "trajectory file");
  if (!text) return fail(text.error());
  auto read = file.extension() == ".csv" ? formats::read_euroc_csv(*text, file.string())
                                         : formats::read_tum(*text, file.string());
  if (!read) return fail(read.error());
  return std::optional(std::move(read->value));
}

}  // namespace weft::evaluate
