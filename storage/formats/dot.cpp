#include "storage/formats/lines.hpp"
#include "storage/formats/network_export.hpp"
#include "storage/formats/relation_text.hpp"

namespace weft::formats {
namespace {

/// Puts a text in DOT's double quotes, in which only the quote is special, and a backslash before one or at the end.
std::string in_quotes(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out + "\"";
}

const char* arrows(Drivable drivable) {
  switch (drivable) {
    case Drivable::a_to_b:
      return "forward";
    case Drivable::b_to_a:
      return "back";
    case Drivable::both:
      return "both";
    case Drivable::none:
      return "none";
  }
  return "none";
}

const char* style(Origin origin) {
  switch (origin) {
    case Origin::odometry:
      return "solid";
    case Origin::blind:
      return "dashed";
    case Origin::stitch:
      return "dotted";
  }
  return "solid";
}

}  // namespace

std::string dot_text(const Window& network, const Poses& frame_from_place) {
  const std::map<PlaceId, std::string> labels = labels_by_place(network);
  std::string text =
      "digraph weft {\n  revision=" + std::to_string(network.revision.value) + ";\n  node [shape=point];\n";
  for (const auto& [id, place] : network.places) {
    text += "  " + in_quotes(to_string(id)) + " [experience=" + in_quotes(to_string(id.experience)) +
            ", method=" + in_quotes(place.method);
    if (const auto label = labels.find(id); label != labels.end()) {
      text += ", shape=box, label=" + in_quotes(label->second);
    }
    if (const auto pose = frame_from_place.find(id); pose != frame_from_place.end()) {
      text += ", pos=" + in_quotes(text_of(pose->second.x) + "," + text_of(pose->second.y) + "!");
    }
    text += "];\n";
  }
  for (const auto& [id, edge] : network.edges) {
    text += "  " + in_quotes(to_string(id.a)) + " -> " + in_quotes(to_string(id.b)) +
            " [origin=" + to_string(edge.origin) + ", style=" + style(edge.origin) +
            ", dir=" + arrows(edge.drivable) + ", kind=" + kind_text(edge.a_from_b) +
            ", a_from_b=" + in_quotes(numbers_text(edge.a_from_b)) + ", method=" + in_quotes(edge.method) + "];\n";
  }
  return text + "}\n";
}

}  // namespace weft::formats
