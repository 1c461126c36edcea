#include <Eigen/Cholesky>
#include <cmath>
#include <map>
#include <set>

#include "storage/formats/g2o.hpp"
#include "storage/formats/lines.hpp"
#include "storage/formats/unit.hpp"

namespace weft::formats {
namespace {

using Words = std::vector<std::string_view>;

class G2oReader {
 public:
  G2oReader(std::string_view text, std::string_view file) : lines_(text), file_(file) {}

  Result<Read<PoseGraph>> run() {
    while (const std::optional<std::string_view> line = lines_.next()) {
      if (const Result<void> taken = take(*line); !taken) return fail(taken.error());
    }
    leave_out_lost();
    return Read<PoseGraph>{std::move(graph_), leftovers_.take()};
  }

 private:
  tl::unexpected<Error> wrong(const std::string& what) const { return fail_at(file_, lines_.number(), what); }

  Result<void> take(std::string_view line) {
    constexpr std::string_view kNote = "# weft ";
    if (line.starts_with(kNote)) graph_.notes.emplace_back(line.substr(kNote.size()));
    const Words words = words_of(line);
    if (words.empty() || words.front().starts_with('#')) return {};
    const std::string_view tag = words.front();
    if (tag == "VERTEX_SE2") return vertex<Pose2, 3>(words);
    if (tag == "VERTEX_SE3:QUAT") return vertex<Pose3, 7>(words);
    if (tag == "EDGE_SE2") return edge<PlanarMeasurement, 3, 3>(words);
    if (tag == "EDGE_SE3:QUAT") return edge<SpatialMeasurement, 7, 6>(words);
    if (tag == "FIX") return fix(words);
    pass_over(words);
    return {};
  }

  /// Reads `keys` vertex ids, then `numbers` numbers, which are all that the line has.
  Result<void> numbers_of(const Words& words, std::size_t keys, std::size_t numbers) {
    if (words.size() != 1 + keys + numbers) {
      return wrong(std::string(words.front()) + " has " + std::to_string(words.size() - 1) + " numbers, it needs " +
                   std::to_string(keys + numbers));
    }
    keys_.clear();
    numbers_.clear();
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (i <= keys) {
        const std::optional<std::uint64_t> key = parse_unsigned(words[i]);
        if (!key.has_value()) return wrong(cited(words[i]) + " is no vertex id, a whole number from 0");
        keys_.push_back(*key);
        continue;
      }
      const std::optional<double> number = parse_finite(words[i]);
      if (!number.has_value()) return wrong(cited(words[i]) + " is no finite number");
      numbers_.push_back(*number);
    }
    return {};
  }

  Result<void> be(bool spatial) {
    if (!spatial_.has_value()) {
      spatial_ = spatial;
      kind_line_ = lines_.number();
    }
    if (*spatial_ == spatial) return {};
    return wrong(std::string("a ") + (spatial ? "spatial" : "planar") + " entry in a graph that line " +
                 std::to_string(kind_line_) + " began as a " + (spatial ? "planar" : "spatial") + " one");
  }

  Result<void> pose(Pose2& into) const {
    into = {numbers_[0], numbers_[1], numbers_[2]};
    return {};
  }
  Result<void> pose(Pose3& into) const {
    into.translation = {numbers_[0], numbers_[1], numbers_[2]};
    const std::optional<Eigen::Quaterniond> unit =
        unit_quaternion(numbers_[6], numbers_[3], numbers_[4], numbers_[5]);
    if (!unit.has_value()) return wrong("the quaternion is not unit within 1e-3");
    into.rotation = *unit;
    return {};
  }

  template <class Pose, std::size_t Size>
  Result<void> vertex(const Words& words) {
    if (const auto read = numbers_of(words, 1, Size); !read) return read;
    if (const auto kind = be(std::is_same_v<Pose, Pose3>); !kind) return kind;
    Pose estimate;
    if (const auto read = pose(estimate); !read) return read;
    const auto [known, is_new] = declared_.emplace(keys_[0], lines_.number());
    if (!is_new) {
      return wrong("vertex " + std::to_string(keys_[0]) + " is declared a second time, first in line " +
                   std::to_string(known->second));
    }
    graph_.vertices.push_back({keys_[0], estimate});
    return {};
  }

  template <class Seen, std::size_t Size, int N>
  Result<void> edge(const Words& words) {
    if (const auto read = numbers_of(words, 2, Size + N * (N + 1) / 2); !read) return read;
    if (const auto kind = be(N == 6); !kind) return kind;
    if (keys_[0] == keys_[1]) return wrong("the edge joins vertex " + std::to_string(keys_[0]) + " to itself");
    Seen seen;
    if (const auto read = pose(seen.a_from_b); !read) return read;
    std::size_t at = Size;
    for (int row = 0; row < N; ++row) {
      for (int column = row; column < N; ++column) {
        seen.information(row, column) = seen.information(column, row) = numbers_[at++];
      }
    }
    if (Eigen::LLT<Eigen::Matrix<double, N, N>>(seen.information).info() != Eigen::Success) {
      return wrong("the information matrix is not positive definite");
    }
    graph_.edges.push_back({keys_[0], keys_[1], seen});
    edge_lines_.push_back(lines_.number());
    return {};
  }

  Result<void> fix(const Words& words) {
    if (words.size() < 2) return wrong("FIX names no vertex");
    if (const auto read = numbers_of(words, words.size() - 1, 0); !read) return read;
    for (const std::uint64_t key : keys_) {
      graph_.fixed.push_back(key);
      fix_lines_.push_back(lines_.number());
    }
    return {};
  }

  /// Notes a vertex that is not taken, a landmark for one, so that what names it is no reference to nowhere.
  void pass_over(const Words& words) {
    leftovers_.note(words.front(), lines_.number());
    if (!words.front().starts_with("VERTEX_") || words.size() < 2) return;
    if (const std::optional<std::uint64_t> key = parse_unsigned(words[1])) passed_over_.insert(*key);
  }

  /// Returns whether a vertex is declared, or another robot's and so in another file; where none is, whether an edge
  /// names it.
  bool is_known(std::uint64_t key) const {
    if (passed_over_.contains(key) && !declared_.contains(key)) return false;
    if (declared_.empty()) return named_.contains(key);
    return declared_.contains(key) || !robots_.contains(robot_of(key));
  }

  void note_missing(const char* what, std::uint64_t key, std::size_t line) {
    const bool is_passed_over = passed_over_.contains(key);
    leftovers_.note(std::string(what) + " a vertex that is not " + (is_passed_over ? "taken" : "declared"), line);
  }

  void leave_out_lost_edges() {
    std::vector<PoseGraph::Edge> kept;
    for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
      const PoseGraph::Edge& edge = graph_.edges[i];
      if (is_known(edge.a) && is_known(edge.b)) {
        kept.push_back(edge);
      } else {
        note_missing("an edge to", is_known(edge.a) ? edge.b : edge.a, edge_lines_[i]);
      }
    }
    graph_.edges = std::move(kept);
  }

  void leave_out_lost_fixes() {
    std::vector<std::uint64_t> kept;
    for (std::size_t i = 0; i < graph_.fixed.size(); ++i) {
      if (is_known(graph_.fixed[i])) {
        kept.push_back(graph_.fixed[i]);
      } else {
        note_missing("FIX of", graph_.fixed[i], fix_lines_[i]);
      }
    }
    graph_.fixed = std::move(kept);
  }

  void leave_out_lost() {
    for (const auto& [key, line] : declared_) robots_.insert(robot_of(key));
    for (const PoseGraph::Edge& edge : graph_.edges) named_.insert({edge.a, edge.b});
    leave_out_lost_edges();
    leave_out_lost_fixes();
  }

  Lines lines_;
  std::string_view file_;
  PoseGraph graph_;
  Leftovers leftovers_;
  std::optional<bool> spatial_;
  std::size_t kind_line_ = 0;
  std::map<std::uint64_t, std::size_t> declared_;  // and in which line
  std::set<std::uint64_t> passed_over_;            // vertices with tags that are not taken
  std::set<std::uint64_t> named_;                  // by edges
  std::set<char> robots_;                          // of the declared ones
  std::vector<std::size_t> edge_lines_;
  std::vector<std::size_t> fix_lines_;
  std::vector<std::uint64_t> keys_;
  std::vector<double> numbers_;
};

}  // namespace

Result<Read<PoseGraph>> read_g2o(std::string_view text, std::string_view file) {
  return G2oReader(text, file).run();
}

}  // namespace weft::formats
