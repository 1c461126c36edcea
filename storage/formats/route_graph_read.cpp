#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "storage/formats/lines.hpp"
#include "storage/formats/route_graph.hpp"

namespace weft::formats {
namespace {

using nlohmann::json;

/// Goes over a text and counts its lines, so that the parser can say where it is. A line ends with the character
/// after its break: the parser reads one past a number.
class Counting {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Counting(std::string_view text, std::size_t from, std::size_t* line)
      : begin_(text.data()), at_(text.data() + from), line_(line) {}
  reference operator*() const { return *at_; }
  Counting& operator++() {
    if (at_ != begin_ && at_[-1] == '\n') ++*line_;
    ++at_;
    return *this;
  }
  Counting operator++(int) {
    Counting before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Counting& other) const { return at_ == other.at_; }
  bool operator!=(const Counting& other) const { return at_ != other.at_; }

 private:
  const char* begin_;
  const char* at_;
  std::size_t* line_;
};

/// Parses the text and notes in `feature_lines` in which line each feature begins.
Result<json> parse(std::string_view text, std::string_view file, std::vector<std::size_t>& feature_lines) {
  constexpr int kFeatureDepth = 2;  // the collection is at 0, its array of features at 1
  constexpr int kDeepest = 64;      // what writes it out again calls itself for each level
  std::size_t line = 1;
  std::size_t too_deep = 0;
  json document;
  std::string key;
  const json::parser_callback_t watch = [&](int depth, json::parse_event_t event, json& parsed) {
    if (depth > kDeepest && too_deep == 0) too_deep = line;
    if (depth == 1 && event == json::parse_event_t::key) key = parsed.get<std::string>();
    const bool begins = event == json::parse_event_t::object_start || event == json::parse_event_t::array_start ||
                        event == json::parse_event_t::value;
    if (depth == kFeatureDepth && begins && key == "features") feature_lines.push_back(line);
    return depth <= kDeepest;
  };
  try {
    document = json::parse(Counting(text, 0, &line), Counting(text, text.size(), &line), watch);
  } catch (const json::parse_error& problem) {
    const std::string_view words = problem.what();
    const std::size_t said = words.find(": ");
    return fail_at(file, line,
                   "no JSON: " + std::string(said == std::string_view::npos ? words : words.substr(said + 2)));
  }
  if (too_deep > 0) return fail_at(file, too_deep, "nested deeper than 64 levels");
  return document;
}

class RouteGraphReader {
 public:
  RouteGraphReader(const json& document, const std::vector<std::size_t>& feature_lines, std::string_view file)
      : document_(document), feature_lines_(feature_lines), file_(file) {}

  Result<Read<RouteGraph>> run() {
    const json& root = document_;
    if (!root.is_object() || text_in(root, "type") != "FeatureCollection" || !root.contains("features") ||
        !root["features"].is_array()) {
      return wrong("a route graph is a GeoJSON FeatureCollection with 'features'");
    }
    graph_.name = text_in(root, "name");
    graph_.date_generated = text_in(root, "date_generated");
    graph_.crs = json_in(root, "crs");
    note_others(root, {"type", "features", "name", "date_generated", "crs"}, "member ");
    const json& features = root["features"];
    for (std::size_t i = 0; i < features.size(); ++i) {
      line_ = i < feature_lines_.size() ? feature_lines_[i] : 1;
      take(features[i]);
      if (!error_.message.empty()) return fail(error_);
    }
    check_ends();
    if (!error_.message.empty()) return fail(error_);
    return Read<RouteGraph>{std::move(graph_), leftovers_.take()};
  }

 private:
  tl::unexpected<Error> wrong(const std::string& what) {
    const tl::unexpected<Error> error = fail_at(file_, line_, what);
    if (error_.message.empty()) error_ = error.value();
    return error;
  }

  void note_others(const json& object, const std::set<std::string>& known, const std::string& as) {
    for (const auto& [key, value] : object.items()) {
      if (!known.contains(key)) leftovers_.note(as + key, line_);
    }
  }

  std::string text_in(const json& object, const char* key) {
    if (!object.contains(key)) return {};
    if (object[key].is_string()) return object[key].get<std::string>();
    wrong(std::string(key) + " must be a text");
    return {};
  }
  static std::string json_in(const json& object, const char* key) {
    return object.contains(key) ? object[key].dump(-1, ' ', false, json::error_handler_t::replace) : std::string{};
  }
  std::uint64_t id_in(const json& object, const char* key) {
    if (object.contains(key) && object[key].is_number_unsigned()) return object[key].get<std::uint64_t>();
    wrong(std::string(key) + " must be a whole number from 0");
    return 0;
  }

  void take(const json& feature) {
    const bool whole = feature.is_object() && text_in(feature, "type") == "Feature" && feature.contains("geometry") &&
                       feature["geometry"].is_object() && feature.contains("properties") &&
                       feature["properties"].is_object();
    if (!whole) {
      wrong("a feature has the type Feature, a geometry and properties");
      return;
    }
    note_others(feature, {"type", "geometry", "properties"}, "member ");
    const json& geometry = feature["geometry"];
    note_others(geometry, {"type", "coordinates"}, "geometry member ");
    const std::string type = text_in(geometry, "type");
    if (type == "Point") {
      node(feature["properties"], geometry);
    } else if (type == "LineString" || type == "MultiLineString") {
      edge(feature["properties"], geometry, type == "MultiLineString");
    } else {
      leftovers_.note("geometry " + cited(type), line_);
    }
  }

  void node(const json& properties, const json& geometry) {
    RouteGraph::Node node;
    node.id = id_in(properties, "id");
    node.position = point(geometry.contains("coordinates") ? geometry["coordinates"] : json());
    node.frame = text_in(properties, "frame");
    node.metadata = json_in(properties, "metadata");
    node.operations = json_in(properties, "operations");
    note_others(properties, {"id", "frame", "metadata", "operations"}, "node property ");
    if (!node_ids_.insert(node.id).second) wrong("node " + std::to_string(node.id) + " stands there a second time");
    graph_.nodes.push_back(std::move(node));
  }

  void edge(const json& properties, const json& geometry, bool multi) {
    RouteGraph::Edge edge;
    edge.id = id_in(properties, "id");
    edge.start = id_in(properties, "startid");
    edge.end = id_in(properties, "endid");
    if (properties.contains("cost")) edge.cost = number(properties["cost"], "cost");
    if (properties.contains("overridable")) {
      if (!properties["overridable"].is_boolean())
        wrong("overridable must be true or false");
      else
        edge.overridable = properties["overridable"].get<bool>();
    }
    edge.metadata = json_in(properties, "metadata");
    edge.operations = json_in(properties, "operations");
    note_others(properties, {"id", "startid", "endid", "cost", "overridable", "metadata", "operations"},
                "edge property ");
    const json coordinates = geometry.contains("coordinates") ? geometry["coordinates"] : json();
    if (!multi && is_list_of_lines(coordinates)) {
      leftovers_.note("a LineString with the coordinates of a MultiLineString", line_);
      multi = true;
    }
    edge.multi = multi;
    if (!multi) edge.lines.push_back(line(coordinates));
    if (multi && !coordinates.is_array()) wrong("coordinates must be a list of lines");
    if (multi && coordinates.is_array()) {
      for (const json& part : coordinates) edge.lines.push_back(line(part));
    }
    // Nav2's own depot has such edges; what an operation names by this id is not one edge.
    if (!edge_ids_.insert(edge.id).second) leftovers_.note("an edge with the id of an earlier one", line_);
    graph_.edges.push_back(std::move(edge));
    edge_lines_.push_back(line_);
  }

  static bool is_list_of_lines(const json& coordinates) {
    const bool nested = coordinates.is_array() && !coordinates.empty() && coordinates.front().is_array();
    return nested && !coordinates.front().empty() && coordinates.front().front().is_array();
  }

  std::vector<Eigen::Vector2d> line(const json& coordinates) {
    std::vector<Eigen::Vector2d> points;
    if (!coordinates.is_array())
      wrong("a line must be a list of [x, y]");
    else
      for (const json& coordinate : coordinates) points.push_back(point(coordinate));
    return points;
  }

  Eigen::Vector2d point(const json& coordinate) {
    if (!coordinate.is_array() || coordinate.size() < 2) {
      wrong("a coordinate must be [x, y] in metres");
      return Eigen::Vector2d::Zero();
    }
    if (coordinate.size() > 2) leftovers_.note("a coordinate's third number", line_);
    return {number(coordinate[0], "x"), number(coordinate[1], "y")};
  }

  double number(const json& value, const char* what) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!std::isfinite(number)) wrong(std::string(what) + " must be a finite number");
    return number;
  }

  void check_ends() {
    for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
      line_ = edge_lines_[i];
      for (const std::uint64_t end : {graph_.edges[i].start, graph_.edges[i].end}) {
        if (!node_ids_.contains(end)) {
          wrong("edge " + std::to_string(graph_.edges[i].id) + " leads to node " + std::to_string(end) +
                ", which does not exist");
        }
      }
    }
  }

  const json& document_;
  const std::vector<std::size_t>& feature_lines_;
  std::string_view file_;
  std::size_t line_ = 1;  // of the feature at hand
  RouteGraph graph_;
  Leftovers leftovers_;
  Error error_;
  std::set<std::uint64_t> node_ids_;
  std::set<std::uint64_t> edge_ids_;
  std::vector<std::size_t> edge_lines_;
};

}  // namespace

Result<Read<RouteGraph>> read_route_graph(std::string_view text, std::string_view file) {
  std::vector<std::size_t> feature_lines;
  const Result<json> document = parse(without_byte_order_mark(text), file, feature_lines);
  if (!document) return fail(document.error());
  return RouteGraphReader(*document, feature_lines, file).run();
}

}  // namespace weft::formats
