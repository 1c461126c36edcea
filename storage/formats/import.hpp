#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/bytes.hpp"
#include "core/network/change.hpp"
#include "core/network/imported.hpp"
#include "storage/formats/pose_graph.hpp"

namespace weft::formats {

/// Returns the robot whose runs the experiences of an import are said to be; made of the import's name.
RobotId import_robot(const std::string& name);

/// Holds a graph as experiences for a server's intake, in the order in which they are to be handed in.
struct Import {
  RobotId robot;  ///< `import_robot`
  std::vector<Batch> batches;
  std::map<ContentHash, Bytes> contents;
  std::vector<std::pair<std::string, PlaceId>> labels;
  std::map<std::uint64_t, PlaceId> place_of_key;
  std::vector<std::string> left_out;  ///< for people, each with its number
};

/// Turns chains into experiences: keys in ascending order, of one robot by their letter (or of one experience, by our
/// own notes), as long as an edge joins each to the next. All other edges become stitches; nobody drives those unless
/// a note says so. Ids are made of `name`, so importing a file again repeats the same batches, which is harmless.
/// Left out: edges to vertices of other files, second edges of a pair.
/// invalid: a name that is no label; a graph without vertices; a place with more edges than a batch can have.
Result<Import> import_of(const PoseGraph& graph, const std::string& name);

/// Describes a content of method `imported`, format 1: docs/formats/content-imported.md.
struct ImportedContent {
  std::uint64_t key = 0;
  std::optional<Estimate> estimate;
};
Bytes encode(const ImportedContent& content);
Result<ImportedContent> decode_imported_content(ByteView bytes);

}  // namespace weft::formats
