#pragma once
#include <optional>
#include <string>

#include "clients/cli/anchor.hpp"
#include "clients/cli/json.hpp"

namespace weft::cli {

/// Returns what `weft map export` writes into a file of that name, by its ending: .g2o, .geojson (Nav2 route graph),
/// .dot, .graphml, .tum (of `experience`, its name, or its hex id or the beginning of that; needed when there are
/// several); any other: JSON (docs/formats/records.md). Poses are those of the layout. invalid: no experience for
/// .tum or one whose id begins otherwise.
Result<std::string> export_text(const Window& network, const Layout& layout, const Names& names, const RunNames& runs,
                                const std::string& file, const std::string& experience);

/// Returns whether such a file has poses, so that anchors mean something.
bool has_poses(const std::string& file);

/// Returns whether a file of that name holds the clouds of places, and not the network.
bool is_of_clouds(const std::string& file);

}  // namespace weft::cli
