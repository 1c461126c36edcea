#include "clients/evaluate/csv.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <limits>

namespace weft::evaluate {
namespace {

using testing::ElementsAre;

TEST(CsvText, WritesRowsAsStudiesAlwaysHave) {
  CsvText csv({"floor", "seed", "error_m", "wrong", "refused"});
  csv.words("old concrete").value(std::uint64_t{7}).number(0.123456789).value(1).value("ambiguous").end_row();
  csv.words("epoxy").value(std::uint64_t{8}).number(std::numeric_limits<double>::quiet_NaN()).value(0).empty();
  csv.end_row();
  EXPECT_EQ(csv.text(),
            "floor,seed,error_m,wrong,refused\n"
            "\"old concrete\",7,0.123457,1,ambiguous\n"
            "\"epoxy\",8,,0,\n");
}

TEST(CsvText, LeavesSoManyCellsEmpty) {
  CsvText csv({"a", "b", "c", "d"});
  csv.empty(3).value("why").end_row();
  csv.value("first").empty(3).end_row();
  EXPECT_EQ(csv.text(), "a,b,c,d\n,,,why\nfirst,,,\n");
}

TEST(CsvText, SplitsARowAtItsCommas) {
  EXPECT_THAT(csv_cells("1,,x"), ElementsAre("1", "", "x"));
  EXPECT_THAT(csv_cells("1,"), ElementsAre("1", ""));
  EXPECT_THAT(csv_cells(""), ElementsAre(""));
}

}  // namespace
}  // namespace weft::evaluate
