#include "clients/evaluate/stereo/study.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/core/utility.hpp>
#include <set>
#include <string>
#include <utility>

#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/stereo/pairs_done.hpp"
#include "clients/evaluate/stereo/rows.hpp"
#include "clients/evaluate/study_file.hpp"
#include "core/camera/camera_file.hpp"

namespace weft::evaluate::stereo {
namespace {

using nlohmann::json;
using Warn = std::function<void(const std::string&)>;

/// Has OpenCV use one thread, as processor time is that of one.
class OneThread {
 public:
  OneThread() : before_(cv::getNumThreads()) { cv::setNumThreads(1); }
  ~OneThread() { cv::setNumThreads(before_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_;
};

/// Says what the rows were measured of.
json study_of(const Recording& recording) {
  std::string calibration;
  for (const agents::CameraModel& camera : {recording.sensor.camera, *recording.sensor.right})
    calibration += camera_file_text(agents::calibration_from(camera), {});
  return {{"study", "stereo"},
          {"recording", recording.name},
          {"pairs", recording.pairs},
          {"calibration", sha256_of(calibration)},
          {"truth", sha256_of(formats::tum_text(recording.truth))},
          {"version", WEFT_VERSION}};
}

std::vector<std::size_t> rates_of(const StereoOptions& options) {
  if (!options.every.empty()) {
    const std::set<std::size_t> sorted(options.every.begin(), options.every.end());
    return {sorted.begin(), sorted.end()};
  }
  const bool is_euroc = std::filesystem::is_directory(options.folder / "mav0");
  if (options.is_quick || !is_euroc) return {1};
  return {1, 2, 4};
}

json points_of(const std::vector<Eigen::Vector3d>& positions) {
  json points = json::array();
  for (const Eigen::Vector3d& position : positions) points.push_back({position.x(), position.y(), position.z()});
  return points;
}

/// Measures one recording into one folder.
class Study {
 public:
  Study(const StereoOptions& options, const Recording& recording, const Surroundings& around, const Warn& warn,
        const std::function<double()>& processor_s)
      : options_(options),
        recording_(recording),
        around_(around),
        warn_(warn),
        processor_s_(processor_s),
        rates_(rates_of(options)),
        study_(study_of(recording)) {}

  Result<Ended> run() {
    Result<Rows> kept = read_rows(file(), study_);
    if (!kept) return fail(kept.error());
    rows_ = std::move(*kept);
    std::size_t there = rows_.dense ? 1 : 0;
    for (const std::size_t every : rates_) there += rows_.find(every) != nullptr ? 1U : 0U;
    RowsMeasured progress(rates_.size() + 1, there, around_);
    for (const std::size_t every : rates_) {
      if (rows_.find(every) != nullptr) continue;
      const Result<bool> measured = follow_at(every);
      if (!measured) return fail(measured.error());
      if (!*measured) return Ended::stopped;
      progress.row("every " + std::to_string(every));
    }
    if (!rows_.dense) {
      const Result<bool> measured = match();
      if (!measured) return fail(measured.error());
      if (!*measured) return Ended::stopped;
      progress.row("dense disparity");
    }
    return report();
  }

 private:
  std::filesystem::path file() const { return options_.out / "stereo.json"; }

  /// Measures a rate and keeps its row. False: stopped.
  Result<bool> follow_at(std::size_t every) {
    const PairsDone done("every " + std::to_string(every), recording_.pairs, around_);
    const Result<std::optional<Followed>> followed =
        follow(recording_,
               {every, processor_s_, warn_, [&](std::size_t pairs) { done.done(pairs); }, around_.asked_to_stop});
    if (!followed) return fail(followed.error());
    if (!*followed) return false;
    const std::optional<Scored> scored = score(**followed, every, recording_.truth);
    if (!scored)
      return fail(ErrorCode::invalid, recording_.folder.string() + ": the truth is known for fewer than " +
                                          std::to_string(kFewestPairs) + " of its pairs, of every " +
                                          std::to_string(every) + " one; do their times belong together?");
    rows_.rates.push_back(scored->row);
    std::sort(rows_.rates.begin(), rows_.rates.end(),
              [](const RateRow& a, const RateRow& b) { return a.every < b.every; });
    const Result<void> shown = write_series(options_.out, "stereo-" + std::to_string(every),
                                            {{"recording", recording_.name},
                                             {"hz", scored->row.hz},
                                             {"truth", points_of(scored->laid.truth)},
                                             {"ours", points_of(scored->laid.ours)},
                                             {"baseline", points_of(scored->laid.baseline)}});
    if (!shown) return fail(shown.error());
    if (const Result<void> kept = write_rows(file(), study_, rows_); !kept) return fail(kept.error());
    return true;
  }

  /// Matches the pairs densely and keeps the row. False: stopped.
  Result<bool> match() {
    const Result<std::optional<DenseRow>> dense = match_densely(
        recording_, {.processor_s = processor_s_, .warn = warn_, .asked_to_stop = around_.asked_to_stop});
    if (!dense) return fail(dense.error());
    if (!*dense) return false;
    rows_.dense = **dense;
    if (const Result<void> kept = write_rows(file(), study_, rows_); !kept) return fail(kept.error());
    return true;
  }

  Result<Ended> report() {
    std::erase_if(rows_.rates, [&](const RateRow& row) {
      return std::find(rates_.begin(), rates_.end(), row.every) == rates_.end();
    });
    if (const Result<void> csv = write_rows_csv(options_.out / "stereo.csv", rows_); !csv) return fail(csv.error());
    const std::vector<std::string> pictures = draw_pictures("stereo", options_.out, around_);
    const Judged judged = judge(recording_.name, rows_);
    around_.out << (options_.is_json ? judged.json : judged.table) << std::flush;
    around_.progress << "weft-evaluate: stereo.csv, stereo.json and " << words_of(pictures) << " are in "
                     << options_.out.string() << '\n';
    return judged.is_met ? Ended::complete : Ended::missed;
  }

  const StereoOptions& options_;
  const Recording& recording_;
  const Surroundings& around_;
  const Warn& warn_;
  const std::function<double()>& processor_s_;
  std::vector<std::size_t> rates_;
  json study_;
  Rows rows_;
};

}  // namespace

Result<Ended> study_stereo(const StereoOptions& options, const Surroundings& around,
                           const std::function<double()>& processor_s) {
  std::set<std::string> told;  // a recording is read once a row
  const Warn warn = [&](const std::string& what) {
    if (told.insert(what).second) around.progress << "weft-evaluate: " << what << '\n';
  };
  const Result<Recording> recording = read_recording(options.folder, options.truth, warn);
  if (!recording) return fail(recording.error());
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  const OneThread one_thread;
  return Study(options, *recording, around, warn, processor_s).run();
}

}  // namespace weft::evaluate::stereo
