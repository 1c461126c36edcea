#include "storage/formats/import.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <optional>
#include <set>

#include "core/network/codec.hpp"
#include "storage/formats/lines.hpp"

namespace weft::formats {
namespace {

constexpr std::size_t kPlacesInBatch = 100;  // their contents fit the queue of the bus
using Pair = std::pair<std::uint64_t, std::uint64_t>;

/// Returns the first bytes of the SHA-256 of the import's name and what is named.
template <std::size_t N>
std::array<std::uint8_t, N> derived(const std::string& name, const std::string& what) {
  const std::string text = "weft import\n" + name + "\n" + what;
  const ContentHash hash = hash_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  std::array<std::uint8_t, N> bytes{};
  std::copy_n(hash.bytes.begin(), N, bytes.begin());
  return bytes;
}

template <class Seen>
auto covariance_of(const Seen& seen) {
  using Matrix = decltype(seen.information);
  const Matrix covariance = seen.information.llt().solve(Matrix::Identity());
  return Matrix(0.5 * (covariance + covariance.transpose()));
}

Relation relation_of(const Measurement& seen) {
  if (const auto* const planar = std::get_if<PlanarMeasurement>(&seen)) {
    return Metric2{planar->a_from_b, covariance_of(*planar)};
  }
  const auto& spatial = std::get<SpatialMeasurement>(seen);
  return Metric3{spatial.a_from_b, covariance_of(spatial)};
}

Drivable turned(Drivable drivable) {
  if (drivable == Drivable::a_to_b) return Drivable::b_to_a;
  return drivable == Drivable::b_to_a ? Drivable::a_to_b : drivable;
}

/// Holds the contents of our own notes; notes that are none of ours are counted.
struct Notes {
  struct Range {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    std::string experience;
  };
  struct Kind {
    Origin origin = Origin::odometry;
    Drivable drivable = Drivable::none;
  };
  std::vector<Range> ranges;
  std::map<Pair, Kind> edges;
  std::vector<std::pair<std::string, std::uint64_t>> labels;
  std::size_t strange = 0;

  /// Returns the experience that a key was of; empty: none is known.
  std::string experience_of(std::uint64_t key) const {
    for (const Range& range : ranges) {
      if (key >= range.first && key - range.first < range.count) return range.experience;
    }
    return {};
  }
};

template <class Value>
std::optional<Value> named(const std::map<std::string_view, Value>& values, std::string_view word) {
  const auto found = values.find(word);
  return found == values.end() ? std::nullopt : std::optional<Value>(found->second);
}

bool read_note(const std::vector<std::string_view>& words, Notes& notes) {
  static const std::map<std::string_view, Origin> kOrigins = {
      {"odometry", Origin::odometry}, {"blind", Origin::blind}, {"stitch", Origin::stitch}};
  static const std::map<std::string_view, Drivable> kDrivable = {
      {"none", Drivable::none}, {"a_to_b", Drivable::a_to_b}, {"b_to_a", Drivable::b_to_a}, {"both", Drivable::both}};
  const std::optional<std::uint64_t> key = words.size() > 1 ? parse_unsigned(words[1]) : std::nullopt;
  if (!key.has_value()) return false;
  if (words[0] == "label" && words.size() == 3 && check_name("label", words[2]).has_value()) {
    notes.labels.emplace_back(words[2], *key);
    return true;
  }
  if (words[0] == "places" && words.size() == 4) {
    const std::optional<std::uint64_t> count = parse_unsigned(words[3]);
    const std::optional<PlaceId> place = parse_place_id(words[2]);
    if (!count.has_value() || !place.has_value()) return false;
    notes.ranges.push_back({*key, *count, to_string(place->experience)});
    return true;
  }
  if (words[0] == "edge" && words.size() == 5) {
    const std::optional<std::uint64_t> other = parse_unsigned(words[2]);
    const auto origin = named(kOrigins, words[3]);
    const auto drivable = named(kDrivable, words[4]);
    if (!other.has_value() || !origin.has_value() || !drivable.has_value()) return false;
    notes.edges[{*key, *other}] = {*origin, *drivable};
    return true;
  }
  return false;
}

Notes notes_of(const PoseGraph& graph) {
  Notes notes;
  for (const std::string& note : graph.notes) notes.strange += read_note(words_of(note), notes) ? 0 : 1;
  return notes;
}

class ImportBuilder {
 public:
  ImportBuilder(const PoseGraph& graph, const std::string& name)
      : graph_(graph), name_(name), notes_(notes_of(graph)) {}

  Result<Import> run() {
    out_.robot = import_robot(name_);
    collect_keys();
    if (keys_.empty()) return fail(ErrorCode::invalid, "the graph has no vertices: nothing to import");
    collect_edges();
    number_places();
    if (const Result<void> built = build(); !built) return fail(built.error());
    for (const auto& [label, key] : notes_.labels) {
      if (out_.place_of_key.contains(key)) out_.labels.emplace_back(label, out_.place_of_key.at(key));
    }
    leave_out(elsewhere_, "edges to vertices of other files");
    leave_out(doubled_, "edges between vertices that another edge joins already");
    leave_out(notes_.strange, "notes of ours that are not understood");
    leave_out(unlike_, "notes of edges that do not suit where they lie");
    return std::move(out_);
  }

 private:
  void leave_out(std::size_t count, const char* what) {
    if (count > 0) out_.left_out.push_back(std::to_string(count) + " " + what);
  }

  void collect_keys() {
    for (const PoseGraph::Vertex& vertex : graph_.vertices) keys_.emplace(vertex.key, vertex.estimate);
    if (!keys_.empty()) return;
    for (const PoseGraph::Edge& edge : graph_.edges) {
      keys_.emplace(edge.a, std::nullopt);
      keys_.emplace(edge.b, std::nullopt);
    }
  }

  void collect_edges() {
    for (const PoseGraph::Edge& edge : graph_.edges) {
      if (!keys_.contains(edge.a) || !keys_.contains(edge.b)) {
        ++elsewhere_;
        continue;
      }
      if (!edges_.emplace(std::minmax(edge.a, edge.b), &edge).second) ++doubled_;
    }
  }

  bool continues(std::uint64_t last, std::uint64_t key) const {
    return edges_.contains({last, key}) && robot_of(last) == robot_of(key) &&
           notes_.experience_of(last) == notes_.experience_of(key);
  }

  void number_places() {
    std::optional<std::uint64_t> last;
    PlaceId id;
    for (const auto& [key, estimate] : keys_) {
      if (last.has_value() && continues(*last, key)) {
        ++id.index;
      } else {
        id = {{big_endian(derived<8>(name_, "experience " + std::to_string(key)).data())}, 0};
      }
      order_.emplace(key, out_.place_of_key.size());
      out_.place_of_key.emplace(key, id);
      last = key;
    }
    for (const auto& [ends, edge] : edges_)
      at_[std::max(order_.at(ends.first), order_.at(ends.second))].push_back(edge);
  }

  Edge edge_of(const PoseGraph::Edge& edge) {
    const bool turn = order_.at(edge.a) > order_.at(edge.b);
    Edge out;
    out.id = {out_.place_of_key.at(turn ? edge.b : edge.a), out_.place_of_key.at(turn ? edge.a : edge.b)};
    out.a_from_b = turn ? inverse(relation_of(edge.seen)) : relation_of(edge.seen);
    out.method = kImportedMethod;
    const bool chained = out.id.a.experience == out.id.b.experience && out.id.b.index == out.id.a.index + 1;
    out.origin = chained ? Origin::odometry : Origin::stitch;
    out.drivable = chained ? Drivable::a_to_b : Drivable::none;
    const auto note = notes_.edges.find({edge.a, edge.b});
    if (note == notes_.edges.end()) return out;
    if (chained == (note->second.origin == Origin::stitch)) {
      ++unlike_;
      return out;
    }
    out.origin = note->second.origin;
    out.drivable = turn ? turned(note->second.drivable) : note->second.drivable;
    return out;
  }

  Place place_of(std::uint64_t key, const std::optional<Estimate>& estimate) {
    Bytes content = encode(ImportedContent{key, estimate});
    Place place;
    place.id = out_.place_of_key.at(key);
    place.method = kImportedMethod;
    place.content_format = 1;
    place.content = {hash_bytes(content), content.size()};
    place.robot = out_.robot;
    out_.contents.emplace(place.content.hash, std::move(content));
    return place;
  }

  Batch& begin(ExperienceId experience, std::uint64_t sequence) {
    Batch batch;
    batch.experience = experience;
    batch.sequence = sequence;
    batch.robot = out_.robot;
    batch.name = name_;
    batch.method = kImportedMethod;
    return out_.batches.emplace_back(std::move(batch));
  }

  void seal() {
    if (out_.batches.empty()) return;
    out_.batches.back().seal = true;
    out_.batches.back().seal_reason = "imported as " + name_;
  }

  Result<void> build() {
    for (const auto& [key, estimate] : keys_) {
      const PlaceId id = out_.place_of_key.at(key);
      const auto& edges = at_[order_.at(key)];
      if (edges.size() > kBatchEdges) {
        return fail(ErrorCode::invalid, "vertex " + std::to_string(key) + " has " + std::to_string(edges.size()) +
                                            " edges; a place can have " + std::to_string(kBatchEdges));
      }
      if (id.index == 0) {
        seal();
        begin(id.experience, 1);
      } else if (out_.batches.back().places.size() == kPlacesInBatch ||
                 out_.batches.back().edges.size() + edges.size() > kBatchEdges) {
        begin(id.experience, out_.batches.back().sequence + 1);
      }
      Batch& batch = out_.batches.back();
      batch.places.push_back(place_of(key, estimate));
      for (const PoseGraph::Edge* const edge : edges) batch.edges.push_back(edge_of(*edge));
    }
    seal();
    return {};
  }

  const PoseGraph& graph_;
  const std::string& name_;
  const Notes notes_;
  Import out_;
  std::map<std::uint64_t, std::optional<Estimate>> keys_;
  std::map<Pair, const PoseGraph::Edge*> edges_;                   // one a pair, the smaller key first
  std::map<std::uint64_t, std::size_t> order_;                     // of keys, as they are handed in
  std::map<std::size_t, std::vector<const PoseGraph::Edge*>> at_;  // edges by their later end
  std::size_t elsewhere_ = 0;
  std::size_t doubled_ = 0;
  std::size_t unlike_ = 0;
};

}  // namespace

RobotId import_robot(const std::string& name) {
  return {derived<16>(name, "robot")};
}

Result<Import> import_of(const PoseGraph& graph, const std::string& name) {
  if (const Result<void> label = check_name("label", name); !label) return fail(label.error());
  return ImportBuilder(graph, name).run();
}

}  // namespace weft::formats
