#include "drawing/canvas.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/storage/temporary_directory.hpp"

namespace weft::drawing {
namespace {

/// Returns the red of a pixel of what is drawn by `draw` on a sheet of 40 x 20.
template <class Draw>
int red_at(int x, int y, const Draw& draw) {
  const storage::TemporaryDirectory folder;
  const std::string file = folder.path() / "c.png";
  Result<Canvas> canvas = Canvas::make(file, 40.0, 20.0);
  draw(*canvas);
  EXPECT_TRUE(canvas->finish().has_value());
  cairo_surface_t* const read = cairo_image_surface_create_from_png(file.c_str());
  const int red = cairo_image_surface_get_data(read)[y * cairo_image_surface_get_stride(read) + 4 * x + 2];
  cairo_surface_destroy(read);
  return red;
}

constexpr Colour kBlack{};

TEST(DrawingCanvas, IsWhiteWhereNothingIsDrawn) {
  EXPECT_EQ(red_at(5, 5, [](Canvas&) {}), 255);
}

TEST(DrawingCanvas, DrawsLinesDotsAndBoxes) {
  EXPECT_EQ(red_at(20, 10, [](Canvas& c) { c.stroke({0.0, 10.5}, {40.0, 10.5}, kBlack, {3.0}); }), 0);
  EXPECT_EQ(red_at(20, 10, [](Canvas& c) { c.dot({20.5, 10.5}, 4.0, kBlack); }), 0);
  EXPECT_EQ(red_at(20, 10, [](Canvas& c) { c.box({10.0, 5.0}, 20.0, 10.0, kBlack, true); }), 0);
  EXPECT_EQ(red_at(20, 10, [](Canvas& c) { c.box({10.0, 5.0}, 20.0, 10.0, kBlack, false); }), 255);
}

TEST(DrawingCanvas, LeavesGapsInDashesAndWhereAPointIsNotFinite) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point> points = {{2.0, 10.5}, {14.0, 10.5}, {none, 10.5}, {26.0, 10.5}, {38.0, 10.5}};
  EXPECT_EQ(red_at(8, 10, [&](Canvas& c) { c.curve(points, kBlack, {3.0}); }), 0);
  EXPECT_EQ(red_at(20, 10, [&](Canvas& c) { c.curve(points, kBlack, {3.0}); }), 255);
  EXPECT_EQ(red_at(10, 10, [](Canvas& c) { c.stroke({0.0, 10.5}, {40.0, 10.5}, kBlack, {1.0, true}); }), 255);
}

TEST(DrawingCanvas, AWordIsAsWideAsItSays) {
  const storage::TemporaryDirectory folder;
  Result<Canvas> canvas = Canvas::make(folder.path() / "c.svg", 40.0, 20.0);
  EXPECT_NEAR(canvas->width_of("word", 20.0), 2.0 * canvas->width_of("word", 10.0), 1e-6);
  EXPECT_TRUE(canvas->finish().has_value());
  EXPECT_GT(std::filesystem::file_size(folder.path() / "c.svg"), 100U);
}

TEST(DrawingCanvas, RefusesOtherEndingsAndNamesAFileThatCannotBeWritten) {
  EXPECT_EQ(Canvas::make("picture.jpg", 40.0, 20.0).error().code, ErrorCode::invalid);
  const storage::TemporaryDirectory folder;
  for (const char* const name : {"none/c.png", "none/c.svg"}) {
    Result<Canvas> canvas = Canvas::make(folder.path() / name, 40.0, 20.0);
    ASSERT_TRUE(canvas.has_value());
    const Result<void> finished = canvas->finish();
    ASSERT_FALSE(finished.has_value());
    EXPECT_EQ(finished.error().code, ErrorCode::exhausted);
    EXPECT_NE(finished.error().message.find(name), std::string::npos) << finished.error().message;
  }
}

}  // namespace
}  // namespace weft::drawing
