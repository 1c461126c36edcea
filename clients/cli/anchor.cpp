#include "clients/cli/anchor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "storage/formats/lines.hpp"

namespace weft::cli {
namespace {

/// A label's place, drawn and in the site.
struct Pair {
  Pose2 drawn;
  Anchor anchor;
};

Result<std::vector<Pair>> pairs_of(const Window& network, const Layout& layout, const std::vector<Anchor>& anchors) {
  std::vector<Pair> pairs;
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
    pairs.push_back({layout.drawing_from_place.at(label->second), anchor});
  }
  return pairs;
}

/// The rotation and translation that bring the drawn positions closest to those of the site (Umeyama 1991, without
/// scale; in the plane the rotation is the direction of a sum).
Result<Pose2> fit(const std::vector<Pair>& pairs) {
  if (pairs.size() == 1) {
    const Anchor& only = pairs.front().anchor;
    if (!only.heading.has_value()) {
      return fail(ErrorCode::invalid,
                  "one anchor needs a heading: --anchor " + only.label + "=X,Y,HEADING; or give a second label");
    }
    return Pose2{only.position.x(), only.position.y(), *only.heading} * pairs.front().drawn.inverse();
  }
  Eigen::Vector2d drawn = Eigen::Vector2d::Zero();
  Eigen::Vector2d site = Eigen::Vector2d::Zero();
  for (const Pair& pair : pairs) {
    drawn += pair.drawn.translation() / static_cast<double>(pairs.size());
    site += pair.anchor.position / static_cast<double>(pairs.size());
  }
  double cosine = 0.0;
  double sine = 0.0;
  double spread = 0.0;
  for (const Pair& pair : pairs) {
    const Eigen::Vector2d from = pair.drawn.translation() - drawn;
    const Eigen::Vector2d to = pair.anchor.position - site;
    cosine += from.dot(to);
    sine += from.x() * to.y() - from.y() * to.x();
    spread += from.norm() * to.norm();
  }
  constexpr double kOnePoint = 1e-6;  // m2
  if (spread < kOnePoint) return fail(ErrorCode::invalid, "the anchors lie in one point: give labels that lie apart");
  const Pose2 turned{0.0, 0.0, std::atan2(sine, cosine)};
  const Eigen::Vector2d moved = site - turned * drawn;
  return Pose2{moved.x(), moved.y(), turned.heading};
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
  const Result<std::vector<Pair>> pairs = pairs_of(network, layout, anchors);
  if (!pairs) return fail(pairs.error());
  const Result<Pose2> site_from_drawing = fit(*pairs);
  if (!site_from_drawing) return fail(site_from_drawing.error());
  const std::size_t island = layout.island.at(network.labels.at(anchors.front().label));
  const auto held = [&](const PlaceId& place) { return layout.island.at(place) == island; };
  Anchored result;
  result.network.revision = network.revision;
  for (const auto& [id, place] : network.places) {
    if (!held(id)) {
      ++result.left_out;
      continue;
    }
    result.network.places.insert_or_assign(id, place);
    result.layout.drawing_from_place.emplace(id, *site_from_drawing * layout.drawing_from_place.at(id));
    result.layout.island.emplace(id, 0);
  }
  for (const auto& [id, edge] : network.edges) {
    if (held(id.a)) result.network.edges.insert_or_assign(id, edge);
  }
  for (const auto& [label, place] : network.labels) {
    if (held(place)) result.network.labels.emplace(label, place);
  }
  index_edges(result.network);
  result.layout.islands = 1;
  for (const Pair& pair : *pairs) {
    const Eigen::Vector2d at = *site_from_drawing * pair.drawn.translation();
    result.worst_m = std::max(result.worst_m, (at - pair.anchor.position).norm());
  }
  return result;
}

std::string to_text(const Anchored& result, std::size_t anchors) {
  std::array<char, 80> words{};
  std::snprintf(words.data(), words.size(), "%zu anchors fit within %.2f m", anchors, result.worst_m);
  std::string text = anchors == 1 ? "held by one anchor" : words.data();
  if (result.left_out > 0) text += ", " + std::to_string(result.left_out) + " places that no anchor holds left out";
  return text;
}

}  // namespace weft::cli
