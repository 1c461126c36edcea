#include "clients/evaluate/study_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate {
namespace {

using nlohmann::json;
using storage::TemporaryDirectory;

struct Read {
  Result<void> result = {};
  int rows = 0;
};
Read read(const TemporaryDirectory& folder, const char* text) {
  const std::filesystem::path file = folder.path() / "study.json";
  if (text != nullptr) std::ofstream(file) << text;
  Read read;
  read.result = read_rows_of(file, {{"software", "1.0"}, {"metres", 6.0}}, "trials",
                             [&](const json& document) { read.rows = document.at("rows").get<int>(); });
  return read;
}

TEST(StudyFile, GivesTheDocumentOfItsOwnStudy) {
  const TemporaryDirectory folder;
  const Read own = read(folder, R"({"study": {"software": "1.0", "metres": 6.0}, "rows": 3})");
  EXPECT_TRUE(own.result.has_value());
  EXPECT_EQ(own.rows, 3);
}

TEST(StudyFile, NoFileIsNoRows) {
  const TemporaryDirectory folder;
  const Read none = read(folder, nullptr);
  EXPECT_TRUE(none.result.has_value());
  EXPECT_EQ(none.rows, 0);
}

TEST(StudyFile, RefusesAnotherStudyAndNamesWhatDiffers) {
  const TemporaryDirectory folder;
  const Read other = read(folder, R"({"study": {"software": "1.0", "metres": 9.0}, "rows": 3})");
  ASSERT_FALSE(other.result.has_value());
  EXPECT_EQ(other.rows, 0);
  EXPECT_EQ(other.result.error().code, ErrorCode::conflict);
  EXPECT_EQ(other.result.error().message, (folder.path() / "study.json").string() +
                                              ": holds the trials of another study (other metres); give another "
                                              "--out, or remove the file");
}

TEST(StudyFile, RefusesWhatIsDamaged) {
  for (const char* const text : {"", "{", "[]", R"({"study": 3})", R"({"study": {"software": "1.0", "metres": 6.0}})",
                                 R"({"study": {"software": "1.0", "metres": 6.0}, "rows": "many"})"}) {
    const TemporaryDirectory folder;
    const Read damaged = read(folder, text);
    ASSERT_FALSE(damaged.result.has_value()) << text;
    const std::string& message = damaged.result.error().message;
    EXPECT_NE(message.find("study.json"), std::string::npos) << message;
  }
}

TEST(StudyFile, ReadsNullAsNotANumber) {
  EXPECT_TRUE(std::isnan(number_from(json())));
  EXPECT_EQ(number_from(json(0.5)), 0.5);
}

}  // namespace
}  // namespace weft::evaluate
