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
    made_.of = snapshot;
    made_.methods = methods;
    next_experience_ = made_.of.experiences().begin();
  }

  std::size_t piece() override;
  double share_done() const override;
  Preparation take() override { return draft_->take(); }

 private:
  /// Describes a stretch of the order that is still to be cut, and the cells it lies in already.
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
    const auto* const known = numbers_.value(place.experience);
    return known == nullptr || place.index >= (*known)->size() ? kNoNode : (**known)[place.index];
  }

  enum class Phase { number, join, lay_out, cut, cells };
  Phase phase_ = Phase::number;
  Preparation made_;
  Snapshot::Experiences::const_iterator next_experience_;
  /// Holds the numbers of an experience's places, by index: in the layout at first, from the cuts on their nodes.
  FlatMap<ExperienceId, std::shared_ptr<std::vector<Node>>> numbers_;
  Layout layout_;
  std::uint32_t next_place_ = 0;
  std::vector<Heading> headings_;
  std::vector<std::uint32_t> order_;  ///< as laid out, breadth first; then as cut
  std::uint32_t next_in_order_ = 0;
  float rightmost_ = 0.0F;
  std::vector<std::uint32_t> part_of_;
  std::uint32_t parts_ = 0;
  std::size_t closed_ = 0;  ///< places in base cells
  std::vector<Task> tasks_;
  std::optional<Bisection> bisection_;          ///< of the last task
  std::array<std::uint32_t, kLevels> cells_{};  ///< so far
  std::unique_ptr<Draft> draft_;
};

std::size_t Preparing::number_experience() {
  if (next_experience_ == made_.of.experiences().end()) {
    phase_ = Phase::join;
    layout_.first_arc.reserve(layout_.places.size() + 1);
    return 1;
  }
  auto nodes = std::make_shared<std::vector<Node>>();
  for (const Place& place : next_experience_->second->places) {
    if (nodes->size() <= place.id.index) nodes->resize(place.id.index + 1, kNoNode);
    (*nodes)[place.id.index] = static_cast<Node>(layout_.places.size());
    layout_.places.push_back(place.id);
  }
  nodes->shrink_to_fit();
  const std::size_t work = 1 + nodes->size() / 8;
  numbers_.emplace(next_experience_->first, std::move(nodes));
  ++next_experience_;
  return work;
}

std::size_t Preparing::join_place() {
  layout_.first_arc.push_back(static_cast<std::uint32_t>(layout_.arcs.size()));
  if (next_place_ == layout_.places.size()) {
    phase_ = Phase::lay_out;
    next_place_ = 0;
    layout_.x.assign(layout_.places.size(), 0.0F);
    layout_.y.assign(layout_.places.size(), 0.0F);
    headings_.resize(layout_.places.size());
    part_of_.assign(layout_.places.size(), 0);
    order_.reserve(layout_.places.size());
    return 1;
  }
  const PlaceId here = layout_.places[next_place_++];
  made_.of.for_each_edge(here, [&](const Edge& edge) {
    const std::uint32_t there = number(other_end(edge, here));
    if (there != kNoNode && can_drive(edge, here) && made_.methods.contains(edge.method))
      layout_.arcs.push_back(there);
  });
  return 1;
}

/// Lays out the neighbours of one place, breadth first over all edges; where loops do not close, the first way
/// counts. Only how good the cells are depends on it.
std::size_t Preparing::lay_out_place() {
  if (next_in_order_ == order_.size()) {
    while (next_place_ < layout_.places.size() && part_of_[next_place_] != 0) ++next_place_;
    if (next_place_ == layout_.places.size()) {
      phase_ = Phase::cut;
      headings_ = {};
      part_of_.assign(layout_.places.size(), 0);
      if (!order_.empty()) tasks_.push_back({0, static_cast<std::uint32_t>(order_.size()), kLevels, {}});
      return 1;
    }
    part_of_[next_place_] = 1;
    layout_.x[next_place_] = order_.empty() ? 0.0F : rightmost_ + kBetweenParts_m;
    order_.push_back(next_place_);
  }
  const std::uint32_t here = order_[next_in_order_++];
  rightmost_ = std::max(rightmost_, layout_.x[here]);
  const PlaceId id = layout_.places[here];
  made_.of.for_each_edge(id, [&](const Edge& edge) {
    const std::uint32_t there = number(other_end(edge, id));
    if (there == kNoNode || part_of_[there] != 0) return;
    part_of_[there] = 1;
    const Pose2 step = planar(relation_from(edge, id));
    const auto [c, s] = headings_[here];
    layout_.x[there] = layout_.x[here] + c * static_cast<float>(step.x) - s * static_cast<float>(step.y);
    layout_.y[there] = layout_.y[here] + s * static_cast<float>(step.x) + c * static_cast<float>(step.y);
    const auto turn_c = static_cast<float>(std::cos(step.heading));
    const auto turn_s = static_cast<float>(std::sin(step.heading));
    headings_[there] = {c * turn_c - s * turn_s, s * turn_c + c * turn_s};
    order_.push_back(there);
  });
  return 2;
}

std::size_t Preparing::cut() {
  if (bisection_) {
    if (!bisection_->step(parts_ + 1)) finish_cut();
    return 1 + Bisection::kPortion / 16;
  }
  if (tasks_.empty()) {
    begin_cells();
    return 1;
  }
  Task& task = tasks_.back();
  const std::uint32_t size = task.last - task.first;
  while (task.level > 0 && size <= kCellPlaces[task.level - 1]) {
    --task.level;
    task.cells[task.level] = cells_[task.level]++;
  }
  if (task.level == 0) {
    close(task);
    tasks_.pop_back();
    return 1 + size / 4;
  }
  bisection_.emplace(layout_, order_, task.first, task.last, part_of_);
  return 1;
}

/// Cuts the last task in two, where the bisection says; the first part comes first.
void Preparing::finish_cut() {
  ++parts_;
  Task first = tasks_.back();
  first.last = tasks_.back().first = bisection_->middle();
  tasks_.push_back(first);
  bisection_.reset();
}

/// Makes the places of a task the next base cell: base cells come in the order of their numbers.
void Preparing::close(const Task& task) {
  auto base = std::make_shared<BaseCell>();
  const auto begin = order_.begin() + task.first;
  std::sort(begin, order_.begin() + task.last);
  base->places.reserve(task.last - task.first);
  for (auto at = begin; at != order_.begin() + task.last; ++at) {
    const PlaceId& place = layout_.places[*at];
    const auto cell = static_cast<std::uint32_t>(made_.base.size());
    (*(*numbers_.find(place.experience)).second)[place.index] =
        node_at(cell, static_cast<std::uint32_t>(base->places.size()));
    base->places.push_back(place);
  }
  base->first_arc.push_back(0);
  made_.base.push_back(std::move(base));
  made_.cells.push_back(task.cells);
  closed_ += task.last - task.first;
}

void Preparing::begin_cells() {
  phase_ = Phase::cells;
  layout_ = {};
  order_ = {};
  part_of_ = {};
  for (const auto& [id, nodes] : numbers_) made_.nodes.emplace(id, nodes);
  numbers_ = {};
  for (std::size_t level = 0; level < kLevels; ++level) {
    std::vector<std::set<std::uint32_t>> children(cells_[level]);
    for (const auto& of_base : made_.cells) {
      if (level > 0) children[of_base[level]].insert(of_base[level - 1]);
    }
    for (const std::set<std::uint32_t>& of_cell : children) {
      auto overlay = std::make_shared<Overlay>();
      overlay->children.assign(of_cell.begin(), of_cell.end());
      made_.overlays[level].push_back(std::move(overlay));
    }
  }
  draft_ = std::make_unique<Draft>(std::move(made_));
  for (std::uint32_t cell = 0; cell < draft_->preparation().base.size(); ++cell) draft_->mark(cell);
}

std::size_t Preparing::piece() {
  switch (phase_) {
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
  return draft_->step();
}

double Preparing::share_done() const {
  const auto all = static_cast<double>(std::max<std::size_t>(1, layout_.places.size()));
  double within = 0.0;
  if (phase_ == Phase::join) within = next_place_ / all;
  if (phase_ == Phase::lay_out) within = next_in_order_ / all;
  if (phase_ == Phase::cut) within = static_cast<double>(closed_) / all;
  if (phase_ == Phase::cells) {
    // Every base cell is made, and then looked at once more for its overlay; the levels above are few.
    const auto cells_to_do = static_cast<double>(2 * std::max<std::size_t>(1, draft_->preparation().base.size()));
    within = 1.0 - std::min(1.0, static_cast<double>(draft_->left_to_do()) / cells_to_do);
  }
  return (static_cast<double>(phase_) + within) / (1.0 + static_cast<double>(Phase::cells));
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
