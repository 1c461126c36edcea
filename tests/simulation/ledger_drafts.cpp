#include "tests/simulation/ledger.hpp"
#include "tests/support/refining_marks.hpp"

namespace weft::simulation {

/// Checks that nothing of a run that is refined leaves its robot before, and that a run is handed in as it was taught
/// only by an agent that did not live when it was taught, or whose disk has refused something: as a whole, and saying
/// so.
void Ledger::check_draft(const Robot& by, const msg::ExperienceBatch& sent) {
  const Batch& batch = sent.batch;
  if (!by.refines) return;
  Run& run = runs_[batch.experience];
  bool is_refined = false;
  for (const Edge& edge : batch.edges) {
    if (edge.id.a.experience != batch.experience) continue;
    is_refined = agents::RefiningMarks::is_refined(edge.a_from_b);
    (is_refined ? run.has_refined : run.has_drafts) = true;
  }
  if (is_refined) ++refined_;
  const std::string what = "batch " + std::to_string(batch.sequence) + " of " + to_string(batch.experience);
  if (run.has_drafts && !run.was_refused && run.taught_in == sent.header.incarnation)
    broken("drafts", by.name + " sent " + what + " before it was refined");
  if (run.has_drafts && run.has_refined) broken("drafts", by.name + " sent a run half refined, with " + what);
  if (batch.seal && run.has_drafts && batch.seal_reason == "taught to its end")
    broken("drafts", by.name + " does not say that it sent a draft, with " + what);
}

}  // namespace weft::simulation
