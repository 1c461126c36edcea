#include <algorithm>
#include <cmath>
#include <utility>

#include "core/network/routing/bisection.hpp"
#include "core/network/routing/draft.hpp"
#include "core/network/routing/routing.hpp"
#include "core/network/routing/work.hpp"

namespace weft::routing {
namespace {

constexpr float kBetweenParts_m = 1000.0F;  ///< unconnected parts of a network are laid out side by side

/// Numbers the places, lays them out, cuts them into cells, and makes these.
class Preparing final : public Work {
 public:
  Preparing(const Snapshot& snapshot, const std::set<std::string>& methods) {
    made.of = snapshot;
    made.methods = methods;
    next_experience = made.of.experiences().begin();
  }

  std::size_t piece() override;
  double share_done() const override;
  Preparation take() override { return draft->take(); }

 private:
  /// A stretch of the order that is still to be cut, and the cells it lies in already.
  struct Task {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::size_t level = kLevels;  ///< of the smallest cell that it lies in or is; kLevels: none
    std::array<std::uint32_t, kLevels> cells{};
  };

  struct Heading {
    float cos = 1.0F;
    float sin = 0.0F;
  };

  std::size_t number_experience();
  std::size_t join_place();
  std::size_t lay_out_place();
  std::size_t cut();
  void finish_cut();
  void close(const Task& task);
  void begin_cells();
  std::uint32_t number(const PlaceId& place) const {
    const auto* const known = numbers.value(place.experience);
    return known == nullptr || place.index >= (*known)->size() ? kNoNode : (**known)[place.index];
  }

  enum class Phase { number, join, lay_out, cut, cells };
  Phase phase = Phase::number;
  Preparation made;
  Snapshot::Experiences::const_iterator next_experience;
  /// Numbers of an experience's places, by the place's index: in the layout at first, from the cuts on their nodes.
  FlatMap<ExperienceId, std::shared_ptr<std::vector<Node>>> numbers;
  Layout layout;
  std::uint32_t next_place = 0;
  std::vector<Heading> headings;
  std::vector<std::uint32_t> order;  ///< as laid out, breadth first; then as cut
  std::uint32_t next_in_order = 0;
  float rightmost = 0.0F;
  std::vector<std::uint32_t> part_of;
  std::uint32_t parts = 0;
  std::size_t closed = 0;  ///< places in base cells
  std::vector<Task> tasks;
  std::optional<Bisection> bisection;          ///< of the last task
  std::array<std::uint32_t, kLevels> cells{};  ///< so far
  std::unique_ptr<Draft> draft;
};

std::size_t Preparing::number_experience() {
  if (next_experience == made.of.experiences().end()) {
    phase = Phase::join;
    layout.first_arc.reserve(layout.places.size() + 1);
    return 1;
  }
  auto nodes = std::make_shared<std::vector<Node>>();
  for (const Place& place : next_experience->second->places) {
    if (nodes->size() <= place.id.index) nodes->resize(place.id.index + 1, kNoNode);
    (*nodes)[place.id.index] = static_cast<Node>(layout.places.size());
    layout.places.push_back(place.id);
  }
  nodes->shrink_to_fit();
  const std::size_t work = 1 + nodes->size() / 8;
  numbers.emplace(next_experience->first, std::move(nodes));
  ++next_experience;
  return work;
}

std::size_t Preparing::join_place() {
  layout.first_arc.push_back(static_cast<std::uint32_t>(layout.arcs.size()));
  if (next_place == layout.places.size()) {
    phase = Phase::lay_out;
    next_place = 0;
    layout.x.assign(layout.places.size(), 0.0F);
    layout.y.assign(layout.places.size(), 0.0F);
    headings.resize(layout.places.size());
    part_of.assign(layout.places.size(), 0);
    order.reserve(layout.places.size());
    return 1;
  }
  const PlaceId here = layout.places[next_place++];
  made.of.for_each_edge(here, [&](const Edge& edge) {
    const std::uint32_t there = number(other_end(edge, here));
    if (there != kNoNode && can_drive(edge, here) && made.methods.contains(edge.method)) layout.arcs.push_back(there);
  });
  return 1;
}

/// Breadth first over all edges; where loops do not close, the first way counts. Only how good the cells are depends
/// on it.
std::size_t Preparing::lay_out_place() {
  if (next_in_order == order.size()) {
    while (next_place < layout.places.size() && part_of[next_place] != 0) ++next_place;
    if (next_place == layout.places.size()) {
      phase = Phase::cut;
      headings = {};
      part_of.assign(layout.places.size(), 0);
      if (!order.empty()) tasks.push_back({0, static_cast<std::uint32_t>(order.size()), kLevels, {}});
      return 1;
    }
    part_of[next_place] = 1;
    layout.x[next_place] = order.empty() ? 0.0F : rightmost + kBetweenParts_m;
    order.push_back(next_place);
  }
  const std::uint32_t here = order[next_in_order++];
  rightmost = std::max(rightmost, layout.x[here]);
  const PlaceId id = layout.places[here];
  made.of.for_each_edge(id, [&](const Edge& edge) {
    const std::uint32_t there = number(other_end(edge, id));
    if (there == kNoNode || part_of[there] != 0) return;
    part_of[there] = 1;
    const Pose2 step = planar(relation_from(edge, id));
    const auto [c, s] = headings[here];
    layout.x[there] = layout.x[here] + c * static_cast<float>(step.x) - s * static_cast<float>(step.y);
    layout.y[there] = layout.y[here] + s * static_cast<float>(step.x) + c * static_cast<float>(step.y);
    const auto turn_c = static_cast<float>(std::cos(step.heading));
    const auto turn_s = static_cast<float>(std::sin(step.heading));
    headings[there] = {c * turn_c - s * turn_s, s * turn_c + c * turn_s};
    order.push_back(there);
  });
  return 2;
}

std::size_t Preparing::cut() {
  if (bisection) {
    if (!bisection->step(parts + 1)) finish_cut();
    return 1 + Bisection::kPortion / 16;
  }
  if (tasks.empty()) {
    begin_cells();
    return 1;
  }
  Task& task = tasks.back();
  const std::uint32_t size = task.last - task.first;
  while (task.level > 0 && size <= kCellPlaces[task.level - 1]) {
    --task.level;
    task.cells[task.level] = cells[task.level]++;
  }
  if (task.level == 0) {
    close(task);
    tasks.pop_back();
    return 1 + size / 4;
  }
  bisection.emplace(layout, order, task.first, task.last, part_of);
  return 1;
}

/// The last task is cut in two; its first part comes first.
void Preparing::finish_cut() {
  ++parts;
  Task first = tasks.back();
  first.last = tasks.back().first = bisection->middle();
  tasks.push_back(first);
  bisection.reset();
}

/// Base cells come in the order of their numbers.
void Preparing::close(const Task& task) {
  auto base = std::make_shared<BaseCell>();
  const auto begin = order.begin() + task.first;
  std::sort(begin, order.begin() + task.last);
  base->places.reserve(task.last - task.first);
  for (auto at = begin; at != order.begin() + task.last; ++at) {
    const PlaceId& place = layout.places[*at];
    const auto cell = static_cast<std::uint32_t>(made.base.size());
    (*(*numbers.find(place.experience)).second)[place.index] =
        node_at(cell, static_cast<std::uint32_t>(base->places.size()));
    base->places.push_back(place);
  }
  base->first_arc.push_back(0);
  made.base.push_back(std::move(base));
  made.cells.push_back(task.cells);
  closed += task.last - task.first;
}

void Preparing::begin_cells() {
  phase = Phase::cells;
  layout = {};
  order = {};
  part_of = {};
  for (const auto& [id, nodes] : numbers) made.nodes.emplace(id, nodes);
  numbers = {};
  for (std::size_t level = 0; level < kLevels; ++level) {
    std::vector<std::set<std::uint32_t>> children(cells[level]);
    for (const auto& of_base : made.cells) {
      if (level > 0) children[of_base[level]].insert(of_base[level - 1]);
    }
    for (const std::set<std::uint32_t>& of_cell : children) {
      auto overlay = std::make_shared<Overlay>();
      overlay->children.assign(of_cell.begin(), of_cell.end());
      made.overlays[level].push_back(std::move(overlay));
    }
  }
  draft = std::make_unique<Draft>(std::move(made));
  for (std::uint32_t cell = 0; cell < draft->preparation().base.size(); ++cell) draft->mark(cell);
}

std::size_t Preparing::piece() {
  switch (phase) {
    case Phase::number:
      return number_experience();
    case Phase::join:
      return join_place();
    case Phase::lay_out:
      return lay_out_place();
    case Phase::cut:
      return cut();
    case Phase::cells:
      break;
  }
  return draft->step();
}

double Preparing::share_done() const {
  const auto all = static_cast<double>(std::max<std::size_t>(1, layout.places.size()));
  double within = 0.0;
  if (phase == Phase::join) within = next_place / all;
  if (phase == Phase::lay_out) within = next_in_order / all;
  if (phase == Phase::cut) within = static_cast<double>(closed) / all;
  if (phase == Phase::cells) {
    // Every base cell is made, and then looked at once more for its overlay; the levels above are few.
    const auto cells_to_do = static_cast<double>(2 * std::max<std::size_t>(1, draft->preparation().base.size()));
    within = 1.0 - std::min(1.0, static_cast<double>(draft->left_to_do()) / cells_to_do);
  }
  return (static_cast<double>(phase) + within) / (1.0 + static_cast<double>(Phase::cells));
}

}  // namespace

Builder Builder::to_prepare(const Snapshot& snapshot, const std::set<std::string>& methods) {
  return Builder(std::make_unique<Preparing>(snapshot, methods));
}

Builder::Builder(std::unique_ptr<Work> work) : work_(std::move(work)) {}
Builder::~Builder() = default;
Builder::Builder(Builder&&) noexcept = default;
Builder& Builder::operator=(Builder&&) noexcept = default;

bool Builder::step(std::size_t budget) {
  for (std::size_t done = 0; done < budget;) {
    const std::size_t piece = work_->piece();
    if (piece == 0) return false;
    done += piece;
  }
  return true;
}

double Builder::share_done() const {
  return work_->share_done();
}

Preparation Builder::take() {
  return work_->take();
}

Preparation Builder::finish() {
  while (work_->piece() != 0) {
  }
  return work_->take();
}

Preparation prepare(const Snapshot& snapshot, const std::set<std::string>& methods) {
  return Builder::to_prepare(snapshot, methods).finish();
}

}  // namespace weft::routing
