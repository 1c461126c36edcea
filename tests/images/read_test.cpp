#include "images/read.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/storage/temporary_directory.hpp"
#include "tests/support/raw_png.hpp"

namespace weft::images {
namespace {

using testing::HasSubstr;

class ReadPicture : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << content;
    return folder_.path() / name;
  }
  Error error_of(const std::filesystem::path& file) const {
    const auto read = images::read(file, Shades::grey);
    EXPECT_FALSE(read);
    return read ? Error{} : read.error();
  }
  storage::TemporaryDirectory folder_;
};

TEST_F(ReadPicture, TheFirstBytesTellTheKindAndNotTheName) {
  const auto png = folder_.path() / "a.jpg";
  test::write_png(png, test::plain_picture(3, 2, 9));
  EXPECT_EQ(read(png, Shades::grey), test::plain_picture(3, 2, 9));
  EXPECT_EQ(read(write("b.png", "P2 1 1 255 7"), Shades::grey), test::plain_picture(1, 1, 7));
}

TEST_F(ReadPicture, WhatIsNoPictureIsNamed) {
  EXPECT_THAT(error_of(write("a.png", "GIF89a")).message,
              HasSubstr("a.png: begins as no picture; PNG, JPEG and PGM"));
  EXPECT_EQ(error_of(write("a.png", "GIF89a")).code, ErrorCode::corrupt);
  EXPECT_THAT(error_of(write("b.png", "")).message, HasSubstr("b.png: is empty"));
}

TEST_F(ReadPicture, WhatCannotBeReadIsNamed) {
  EXPECT_EQ(error_of(folder_.path() / "none.png").code, ErrorCode::not_found);
  EXPECT_THAT(error_of(folder_.path() / "none.png").message, HasSubstr("none.png: No such file"));
  EXPECT_EQ(error_of(folder_.path()).code, ErrorCode::unavailable) << "a folder";
}

TEST_F(ReadPicture, AFileOfMoreThanAGigabyteIsRefusedUnread) {
  const auto file = write("a.png", "x");
  std::filesystem::resize_file(file, (std::uintmax_t{1} << 30U) + 1);
  EXPECT_EQ(error_of(file).code, ErrorCode::exhausted);
}

}  // namespace
}  // namespace weft::images
