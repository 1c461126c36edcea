#include "clients/evaluate/heading/known_shifts.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <sstream>

#include "clients/evaluate/files.hpp"
#include "core/text.hpp"

namespace weft::evaluate::heading {
namespace {

namespace fs = std::filesystem;

constexpr double kMostPx = 1e5;

/// Returns the file of this name with any ending of an image that is read; none: there is no such file.
std::optional<fs::path> with_any_ending(const fs::path& stem) {
  for (const char* const ending : {".png", ".pgm", ".jpg", ".jpeg"}) {
    const fs::path file = stem.string() + ending;
    if (fs::exists(file)) return file;
  }
  return std::nullopt;
}

using Numbers = std::vector<double>;

/// Reads the numbers of each line that has any.
Result<std::vector<Numbers>> read_numbers(const fs::path& file) {
  const Result<std::string> text = read_text(file, "table of shifts");
  if (!text) return fail(text.error());
  std::istringstream lines{std::string(without_byte_order_mark(*text))};
  std::vector<Numbers> rows;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::istringstream words(line);
    Numbers row;
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (*end != '\0' || !(std::abs(value) <= kMostPx)) {
        return fail(ErrorCode::invalid, file.string() + ":" + std::to_string(number) + ": '" + word +
                                            "' is not a number of pixels within +-100000");
      }
      row.push_back(value);
    }
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

std::string two_digits(std::size_t number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

/// Adds images by name, each once.
class Images {
 public:
  explicit Images(ShiftedImages& into) : into_(into) {}
  Result<std::size_t> index_of(const fs::path& stem) {
    const auto known = known_.find(stem);
    if (known != known_.end()) return known->second;
    const std::optional<fs::path> file = with_any_ending(stem);
    if (!file)
      return fail(ErrorCode::not_found,
                  stem.string() + ".*: no such image (PNG, PGM or JPEG), though its shift is listed");
    into_.images.push_back(*file);
    return known_[stem] = into_.images.size() - 1;
  }

 private:
  ShiftedImages& into_;
  std::map<fs::path, std::size_t> known_;
};

Result<void> add_location(const fs::path& folder, std::size_t location, const std::vector<Numbers>& square,
                          Images& images, ShiftedImages& out) {
  const fs::path file = folder / "ground_truth" / ("location_" + std::to_string(location) + ".txt");
  std::vector<std::size_t> of_season;
  for (std::size_t season = 0; season < square.size(); ++season) {
    if (square[season].size() != square.size()) {
      return fail(ErrorCode::invalid, file.string() + ": row " + std::to_string(season + 1) + " has " +
                                          std::to_string(square[season].size()) + " numbers, there are " +
                                          std::to_string(square.size()) + " rows; it is to be a square");
    }
    const auto index = images.index_of(folder / "images" / (two_digits(season + 1) + two_digits(location)));
    if (!index) return fail(index.error());
    of_season.push_back(*index);
  }
  const std::string group = "location " + std::to_string(location);
  for (std::size_t i = 0; i < square.size(); ++i)
    for (std::size_t j = i + 1; j < square.size(); ++j)
      out.pairs.push_back({group, of_season[i], of_season[j], square[i][j]});
  return {};
}

Result<ShiftedImages> read_seasons(const fs::path& folder) {
  ShiftedImages out;
  Images images(out);
  for (std::size_t location = 1;; ++location) {
    const fs::path file = folder / "ground_truth" / ("location_" + std::to_string(location) + ".txt");
    if (location > 1 && !fs::exists(file)) return out;
    const auto square = read_numbers(file);
    if (!square) return fail(square.error());
    if (const Result<void> added = add_location(folder, location, *square, images, out); !added)
      return fail(added.error());
  }
}

Result<ShiftedImages> read_path(const fs::path& folder) {
  ShiftedImages out;
  Images images(out);
  const fs::path file = folder / "displacements.txt";
  const auto rows = read_numbers(file);
  if (!rows) return fail(rows.error());
  for (std::size_t row = 0; row < rows->size(); ++row) {
    const Numbers& numbers = (*rows)[row];
    const bool is_numbered = numbers.size() == 3;
    if (!is_numbered && numbers.size() != 2) {
      return fail(ErrorCode::invalid, file.string() + ": row " + std::to_string(row + 1) + " has " +
                                          std::to_string(numbers.size()) +
                                          " numbers; it is to be the image's number, pixels right, pixels down");
    }
    char name[16];
    std::snprintf(name, sizeof name, "%09.0f", is_numbered ? numbers[0] : static_cast<double>(row));
    const auto a = images.index_of(folder / "season_00" / name);
    if (!a) return fail(a.error());
    const auto b = images.index_of(folder / "season_01" / name);
    if (!b) return fail(b.error());
    out.pairs.push_back({folder.filename().string(), *a, *b, numbers[is_numbered ? 1 : 0]});
  }
  return out;
}

}  // namespace

Result<ShiftedImages> read_known_shifts(const fs::path& folder) {
  if (fs::exists(folder / "displacements.txt")) return read_path(folder);
  if (fs::exists(folder / "ground_truth" / "location_1.txt")) return read_seasons(folder);
  return fail(ErrorCode::not_found, folder.string() +
                                        ": neither ground_truth/location_1.txt with images/ nor displacements.txt "
                                        "with season_00/ and season_01/ is there");
}

}  // namespace weft::evaluate::heading
