#include "clients/cli/anchor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "clients/cli/part_on_plan.hpp"
#include "core/network/site_frame.hpp"
#include "storage/formats/lines.hpp"

namespace weft::cli {
namespace {

Result<std::vector<SitePick>> picks_of(const Window& network, const Layout& layout,
                                       const std::vector<Anchor>& anchors) {
  std::vector<SitePick> picks;
  std::optional<std::size_t> island;
  for (const Anchor& anchor : anchors) {
    const auto label = network.labels.find(anchor.label);
    if (label == network.labels.end()) {
      return fail(ErrorCode::not_found, "anchor " + anchor.label + ": the network has no such label");
    }
    const std::size_t at = layout.island.at(label->second);
    if (island.value_or(at) != at) {
      return fail(ErrorCode::invalid,
                  "anchor " + anchor.label + " lies in a part of the network that nothing joins to the others' part");
    }
    island = at;
    SitePick pick;
    pick.name = anchor.label;
    pick.layout_from_place = layout.drawing_from_place.at(label->second);
    pick.on_plan = anchor.position;
    pick.heading = anchor.heading;
    picks.push_back(std::move(pick));
  }
  return picks;
}

}  // namespace

Result<Anchor> parse_anchor(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::vector<std::string_view> numbers = equals == std::string_view::npos
                                                    ? std::vector<std::string_view>{}
                                                    : formats::cells_of(text.substr(equals + 1), ',');
  std::vector<double> values;
  for (const std::string_view number : numbers) {
    const std::optional<double> value = formats::parse_finite(number);
    if (value.has_value()) values.push_back(*value);
  }
  if (equals == 0 || values.size() != numbers.size() || values.size() < 2 || values.size() > 3) {
    return fail(ErrorCode::invalid, "'" + std::string(text) +
                                        "' is no anchor; write LABEL=X,Y or LABEL=X,Y,HEADING in metres and radians");
  }
  Anchor anchor{std::string(text.substr(0, equals)), {values[0], values[1]}, std::nullopt};
  if (values.size() == 3) anchor.heading = values[2];
  return anchor;
}

Result<Anchored> anchored(const Window& network, const Layout& layout, const std::vector<Anchor>& anchors) {
  if (anchors.empty())
    return fail(ErrorCode::invalid, "nothing says where the network lies: give --anchor LABEL=X,Y,HEADING");
  const Result<std::vector<SitePick>> picks = picks_of(network, layout, anchors);
  if (!picks) return fail(picks.error());
  const Result<SiteFrame> frame = fit_site_frame(*picks);
  if (!frame) return fail(frame.error().code, "--anchor: " + frame.error().message);
  const Pose2& site_from_drawing = frame->plan_from_layout;
  const std::size_t island = layout.island.at(network.labels.at(anchors.front().label));
  PartOnPlan part = part_on_plan(network, [&](const PlaceId& place) {
    return layout.island.at(place) == island ? std::optional(site_from_drawing * layout.drawing_from_place.at(place))
                                             : std::nullopt;
  });
  Anchored result;
  result.network = std::move(part.network);
  result.layout = std::move(part.layout);
  result.left_out = part.left_out;
  for (const std::size_t pick : frame->left_out)
    result.contradicting.push_back({anchors[pick].label, frame->off_m[pick]});
  for (std::size_t pick = 0; pick < anchors.size(); ++pick) {
    const bool counts = std::count(frame->left_out.begin(), frame->left_out.end(), pick) == 0;
    if (counts) result.worst_m = std::max(result.worst_m, frame->off_m[pick]);
  }
  return result;
}

std::string to_text(const Anchored& result, std::size_t anchors) {
  std::array<char, 80> words{};
  std::snprintf(words.data(), words.size(), "%zu anchors fit within %.2f m", anchors - result.contradicting.size(),
                result.worst_m);
  std::string text = anchors == 1 ? "held by one anchor" : words.data();
  for (const Contradicting& anchor : result.contradicting) {
    std::snprintf(words.data(), words.size(), " contradicts the others by %.2f m and is left out", anchor.off_m);
    text += ", " + anchor.label + words.data();
  }
  if (result.left_out > 0) text += ", " + std::to_string(result.left_out) + " places that no anchor holds left out";
  return text;
}

}  // namespace weft::cli
