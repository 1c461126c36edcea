#include "tests/agents/agent/process/calibrate/images/board_images.hpp"

#include <opencv2/imgcodecs.hpp>

#include "tests/support/board_view.hpp"

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
    cv::imwrite(folder.file("view" + std::to_string(i) + ".png"),
                cv::Mat(image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels->data())));
  }
  cv::imwrite(folder.file("blank.png"), cv::Mat(240, 320, CV_8U, cv::Scalar(90)));
  folder.write("broken.jpg", "no picture");
}

int width_of(const std::string& picture) {
  return cv::imread(picture).cols;
}

}  // namespace weft::agents::test
