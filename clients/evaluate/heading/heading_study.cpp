#include "clients/evaluate/heading/heading_study.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "agents/perception/heading_vote.hpp"
#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/heading/known_shifts.hpp"
#include "clients/evaluate/table.hpp"
#include "images/read.hpp"

namespace weft::evaluate::heading {
namespace {

using agents::UprightFeature;

constexpr double kRightPx = 35.0;  // the bound of GRIEF's authors

struct Tally {
  std::size_t pairs = 0, right = 0, refused = 0;
  std::vector<double> errors_px;

  void add(const tl::expected<agents::HeadingVote, agents::Undecided>& vote, double truth_px) {
    ++pairs;
    if (!vote) {
      ++refused;
      return;
    }
    errors_px.push_back(std::abs(vote->shift_px - truth_px));
    right += errors_px.back() <= kRightPx ? 1U : 0U;
  }
  double median_px() const { return floor::median_worst(errors_px).median; }
};

Result<agents::Image> read_image(const std::filesystem::path& file) {
  Result<images::Picture> grey = images::read(file, images::Shades::grey);
  if (!grey) return fail(grey.error());
  return agents::Image{grey->width, grey->height, std::make_shared<const Bytes>(std::move(grey->samples))};
}

std::string json_of(const Tally& all) {
  const double median = all.median_px();
  nlohmann::ordered_json json = {{"pairs", all.pairs}, {"within_35_px", all.right}};
  json["median_error_px"] = std::isfinite(median) ? nlohmann::ordered_json(median) : nlohmann::ordered_json();
  json["refused"] = all.refused;
  return json.dump() + "\n";
}

std::string table_of(const std::map<std::string, Tally>& tallies, const Tally& all) {
  std::vector<std::vector<std::string>> rows = {{"place", "pairs", "within 35 px", "median error px", "refused"}};
  const auto add = [&](const std::string& name, const Tally& tally) {
    rows.push_back({name, std::to_string(tally.pairs), std::to_string(tally.right), cell(tally.median_px(), 1),
                    std::to_string(tally.refused)});
  };
  for (const auto& [group, tally] : tallies) add(group, tally);
  if (tallies.size() > 1) add("all", all);
  return markdown_table(rows, 1);
}

}  // namespace

Result<Ended> study_heading(const HeadingOptions& options, const Surroundings& around) {
  const Result<ShiftedImages> known = read_known_shifts(options.folder);
  if (!known) return fail(known.error());
  agents::UprightConfig config;
  config.description = options.feature;
  config.count = options.features;
  config.cell_widths = options.cell_widths;
  std::vector<std::vector<UprightFeature>> features;
  std::vector<double> widths;
  for (const std::filesystem::path& file : known->images) {
    if (around.asked_to_stop()) return Ended::stopped;
    const Result<agents::Image> image = read_image(file);
    if (!image) return fail(image.error());
    features.push_back(agents::upright_features(*image, config));
    widths.push_back(image->width);
    around.progress << '\r' << features.size() << " of " << known->images.size() << " images" << std::flush;
  }
  around.progress << '\n';
  std::map<std::string, Tally> tallies;
  Tally all;
  for (const KnownShift& pair : known->pairs) {
    if (around.asked_to_stop()) return Ended::stopped;
    const auto vote = agents::vote_heading(features[pair.a], features[pair.b], widths[pair.a], {});
    tallies[pair.group].add(vote, pair.shift_px);
    all.add(vote, pair.shift_px);
  }
  around.out << (options.json ? json_of(all) : table_of(tallies, all)) << std::flush;
  return Ended::complete;
}

}  // namespace weft::evaluate::heading
