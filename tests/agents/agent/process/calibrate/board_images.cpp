#include "tests/agents/agent/process/calibrate/board_images.hpp"

#include "images/read.hpp"
#include "tests/support/board_view.hpp"
#include "tests/support/raw_png.hpp"

namespace weft::agents::test {

void take_images(const Folder& folder, const ChessBoard& board, const CameraModel& camera, int count,
                 double tilt_rad) {
  const Print print = print_of(board);
  Random random(3);
  for (int i = 0; i < count; ++i) {
    const double around = 2.4 * i;
    const Pose3 pose = held(print, camera, {160.0 + 60.0 * std::cos(around), 120.0 + 40.0 * std::sin(around)}, 0.4,
                            tilt_rad * std::cos(1.7 * around), tilt_rad * std::sin(1.7 * around), 0.05 * i);
    const Image image = view_of(print, camera, pose, random);
    weft::test::write_png(folder.file("view" + std::to_string(i) + ".png"),
                          {images::Shades::grey, image.width, image.height, *image.pixels});
  }
  weft::test::write_png(folder.file("blank.png"), weft::test::plain_picture(320, 240, 90));
  folder.write("broken.jpg", "no picture");
}

int width_of(const std::string& picture) {
  const auto read = images::read(picture, images::Shades::grey);
  return read ? read->width : 0;
}

}  // namespace weft::agents::test
