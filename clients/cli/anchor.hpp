#pragma once
#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clients/cli/layout.hpp"

namespace weft::cli {

/// Describes where a labelled place lies in a frame of the site: that of a floor plan, or of an exported file.
struct Anchor {
  std::string label;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< metres
  std::optional<double> heading;                       ///< of a robot at the place, radians
};

/// Reads "LABEL=X,Y" or "LABEL=X,Y,HEADING". invalid: the text is anything else; names what is wrong.
Result<Anchor> parse_anchor(std::string_view text);

/// Describes an anchor that lies elsewhere than all the others say.
struct Contradicting {
  std::string label;
  double off_m = 0.0;
};

/// Holds a network moved into the site's frame: the part of it that the anchors hold.
struct Anchored {
  Window network;
  Layout layout;         ///< in the site's frame
  double worst_m = 0.0;  ///< how far the farthest anchored place lies from where it was said to be
  std::vector<Contradicting> contradicting;  ///< anchors that were left out
  std::size_t left_out = 0;                  ///< places in parts that no anchor holds
};

/// Moves a network by its anchors (core/network/site_frame.hpp): one needs a heading; of several the positions alone
/// are fitted, turned and moved but never stretched, and of four or more those that contradict the others are left
/// out. not_found: a label that the network does not have; invalid: no anchors, one without a heading, anchors in
/// parts of the network that nothing joins, or all within a metre.
Result<Anchored> anchored(const Window& network, const Layout& layout, const std::vector<Anchor>& anchors);

/// Returns how well the anchors fit, for people: "the anchors fit within 0.12 m".
std::string to_text(const Anchored& result, std::size_t anchors);

}  // namespace weft::cli
