#include "storage/formats/lines.hpp"
#include "storage/formats/network_export.hpp"
#include "storage/formats/relation_text.hpp"

namespace weft::formats {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        // XML has no other control characters, not even escaped.
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

std::string key(const char* name, const char* of, const char* type) {
  return std::string("  <key id=\"") + name + "\" for=\"" + of + "\" attr.name=\"" + name + "\" attr.type=\"" + type +
         "\"/>\n";
}

std::string data(const char* name, const std::string& value) {
  return std::string("<data key=\"") + name + "\">" + escaped(value) + "</data>";
}

}  // namespace

std::string graphml_text(const Window& network, const Poses& frame_from_place) {
  const std::map<PlaceId, std::string> labels = labels_by_place(network);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  for (const char* const name : {"experience", "robot", "place_method", "labels"})
    text += key(name, "node", "string");
  text += key("index", "node", "long");
  for (const char* const name : {"x", "y", "heading"}) text += key(name, "node", "double");
  for (const char* const name : {"origin", "kind", "a_from_b", "drivable", "method"}) {
    text += key(name, "edge", "string");
  }
  text += key("length_m", "edge", "double") + "  <graph id=\"revision-" + std::to_string(network.revision.value) +
          "\" edgedefault=\"directed\">\n";
  for (const auto& [id, place] : network.places) {
    text += "    <node id=\"" + to_string(id) + "\">" + data("experience", to_string(id.experience)) +
            data("robot", to_string(place.robot)) + data("place_method", place.method) +
            data("index", std::to_string(id.index));
    if (const auto label = labels.find(id); label != labels.end()) text += data("labels", label->second);
    if (const auto pose = frame_from_place.find(id); pose != frame_from_place.end()) {
      text += data("x", text_of(pose->second.x)) + data("y", text_of(pose->second.y)) +
              data("heading", text_of(pose->second.heading));
    }
    text += "</node>\n";
  }
  for (const auto& [id, edge] : network.edges) {
    text += "    <edge source=\"" + to_string(id.a) + "\" target=\"" + to_string(id.b) + "\">" +
            data("origin", to_string(edge.origin)) + data("kind", kind_text(edge.a_from_b)) +
            data("a_from_b", numbers_text(edge.a_from_b)) + data("drivable", drivable_text(edge.drivable)) +
            data("method", edge.method) + data("length_m", text_of(distance_m(edge.a_from_b))) + "</edge>\n";
  }
  return text + "  </graph>\n</graphml>\n";
}

}  // namespace weft::formats
