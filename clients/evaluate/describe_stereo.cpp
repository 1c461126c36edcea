#include "clients/evaluate/invocation_words.hpp"

namespace weft::evaluate {

CLI::App* describe(CLI::App& app, StereoOptions& options) {
  constexpr std::size_t most_every = 100;
  CLI::App* const sub = app.add_subcommand(
      "stereo",
      "How well a recorded pair of cameras is followed by the visual odometry of the method topometric, and matched "
      "densely, beside OpenCV (KLT + PnP, SGBM) on the same images (docs/results/stereo.md). DIR is laid out as "
      "EuRoC's recordings or KITTI's odometry. Ends with 1 when ours is worse than KLT + PnP, or something that is "
      "asked of the recording by its name does not hold.\n"
      "Writes stereo.csv, .json and .png. Ctrl-C stops it; the same command goes on where it stopped.");
  sub->add_option("DIR", options.folder, "Recording: mav0/cam0 and mav0/cam1, or calib.txt, image_l and image_r")
      ->required()
      ->type_name("");
  const auto option = flags_of(sub);
  option("--every", options.every, "N,...",
         "Take every N-th pair only, 1 to 100; several are several rows [1, of EuRoC's 1,2,4]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(std::size_t{1}, most_every).description(""));
  option("--truth", options.truth, "FILE",
         "Where the body truly was: TUM's format, or EuRoC's where it ends in .csv; of KITTI its poses [in DIR]");
  sub->add_flag("--quick", options.is_quick, "Every pair alone");
  sub->add_flag("--json", options.is_json, "One line of JSON instead of the tables");
  option("--out", options.out, "OUT",
         "Folder for the results, one for each recording; rows that it holds already are kept [out/stereo/DIR]");
  return sub;
}

}  // namespace weft::evaluate
