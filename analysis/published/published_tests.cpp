// Printed tests, statements and preferences beside those of a run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/published/published.h"
#include "analysis/results.h"

namespace promenade::analysis {
namespace {

constexpr double level = 0.05;

struct Wanted {
  int measure = -1, task = -1;
  int a = -1, b = -1;  // interfaces
  int target = -1;
  Pooling pooling = Pooling::participants;

  bool exists() const { return measure >= 0 && task >= 0 && a >= 0 && b >= 0; }
};

// Null: nobody has both values. `turned`: the comparison is b - a.
const Comparison* find(const std::vector<Comparison>& comparisons, const Wanted& wanted,
                       bool& turned) {
  if (!wanted.exists()) return nullptr;
  for (const Comparison& one : comparisons) {
    if (one.measure != wanted.measure || one.task != wanted.task) continue;
    if (one.pooling != wanted.pooling || one.target != wanted.target) continue;
    turned = one.a == wanted.b && one.b == wanted.a;
    const bool same = turned || (one.a == wanted.a && one.b == wanted.b);
    if (same && one.test.n > 0) return &one;
  }
  return nullptr;
}

// By the estimate, by ranks where that is zero. Negative: a has the smaller values.
int sign_of(const Comparison& one, bool turned) {
  const double by_ranks = one.test.rank_biserial.value_or(0);
  const double d = one.hl.value_or(0) != 0 ? *one.hl : by_ranks;
  const int sign = d < 0 ? -1 : d > 0 ? 1 : 0;
  return turned ? -sign : sign;
}

std::string smaller(const Results& results, int a, int b, int sign) {
  if (sign == 0) return "neither";
  return item(results.data.interfaces, sign < 0 ? a : b);
}

std::string pair_words(std::string_view what, std::string_view a, std::string_view b) {
  return fmt::format("{}: {} − {}", what, a, b);
}

// Of the guess for D, of what follows it for times.
int task_of(const Results& results, std::string_view measure) {
  const bool guess = measure == "d_final";
  const int d = results.data.measure("d_final");
  for (int task = 0; task < size_of(results.data.tasks); ++task) {
    if (item(results.data.tasks, task).guess == guess && results.data.occurs(d, task)) return task;
  }
  return -1;
}

void add_note(std::string_view sentence, PublishedRow& row) {
  row.note += (row.note.empty() ? "" : " ") + std::string(sentence);
}

PublishedRow row_of(const Results& results, const PrintedTest& printed) {
  PublishedRow row;
  row.kind = "test";
  row.what =
      pair_words(printed.measure == "d_final" ? "D of the guess" : "time", printed.a, printed.b);
  row.target = printed.target == 0 ? "all" : fmt::format("target {}", printed.target);
  row.place = "[O] 6";
  row.printed = printed.p;
  if (printed.needs_ties) {
    add_note("Without ties, zeros or a missing person 13 differences cannot have the printed p.",
             row);
  }
  Wanted wanted;
  wanted.measure = results.data.measure(printed.measure);
  wanted.task = task_of(results, printed.measure);
  wanted.a = interface_of_type(results, printed.a);
  wanted.b = interface_of_type(results, printed.b);
  wanted.target = printed.target - 1;
  wanted.pooling = printed.target == 0 ? Pooling::trials : Pooling::none;
  bool turned = false;
  const Comparison* one = find(results.comparisons, wanted, turned);
  if (!one) return row;
  row.n = one->test.n;
  if (one->test.normal) row.run = one->test.normal->two;
  row.direction = smaller(results, wanted.a, wanted.b, sign_of(*one, turned));
  if (row.run) row.agrees = (printed.p < level) == (*row.run < level);
  if (!row.run) add_note("All differences are zero, so that there is no test.", row);
  wanted.pooling = printed.target == 0 ? Pooling::participants : Pooling::none;
  const Comparison* ours = find(results.comparisons, wanted, turned);
  if (ours && ours->test.exact) row.p_exact = ours->test.exact->two;
  return row;
}

bool is_of(const Results& results, int task, ClaimedTask claimed) {
  if (claimed == ClaimedTask::any) return true;
  const bool made = results.data.occurs(results.data.measure("d_final"), task);
  return made == (claimed == ClaimedTask::match);
}

// "<" where a has the smaller values; equal is what no test shows to differ.
bool holds(Claim claim, double p, int sign) {
  if (claim == Claim::equal) return p >= level;
  return p < level && sign == (claim == Claim::a_less ? -1 : 1);
}

PublishedRow row_of(const PrintedClaim& claim) {
  PublishedRow row;
  row.kind = "claim";
  row.what = std::string(claim.words);
  row.place = std::string(claim.place);
  row.printed_words = "no difference";
  if (claim.claim == Claim::a_less) row.printed_words = fmt::format("smaller with {}", claim.a);
  if (claim.claim == Claim::a_more) row.printed_words = fmt::format("smaller with {}", claim.b);
  return row;
}

void fill(const Results& results, const PrintedClaim& claim, const Comparison& one, bool turned,
          int a, int b, PublishedRow& row) {
  const int sign = sign_of(one, turned);
  row.n = one.test.n;
  row.direction = smaller(results, a, b, sign);
  row.p_exact = one.p;
  if (!one.p) return;
  row.run = one.p;
  row.agrees = holds(claim.claim, *one.p, sign);
  row.run_words = fmt::format("smaller with {}, p {}", row.direction, p_text(*one.p));
  if (sign == 0) row.run_words = "no difference at all";
}

// Where a claim is about several tasks, a row for each.
std::vector<PublishedRow> by_trials(const Results& results, const PrintedClaim& claim, int a,
                                    int b) {
  std::vector<PublishedRow> rows;
  Wanted wanted;
  wanted.measure = results.data.measure(claim.measure);
  wanted.a = a;
  wanted.b = b;
  for (wanted.task = 0; wanted.task < size_of(results.data.tasks); ++wanted.task) {
    if (!is_of(results, wanted.task, claim.task)) continue;
    bool turned = false;
    const Comparison* one = find(results.comparisons, wanted, turned);
    if (!one) continue;
    PublishedRow row = row_of(claim);
    row.target = "task " + item(results.data.tasks, wanted.task).name;
    fill(results, claim, *one, turned, a, b, row);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<PublishedRow> by_answers(const Results& results, const PrintedClaim& claim, int a,
                                     int b) {
  std::vector<PublishedRow> rows;
  for (const QuestionnaireResult& one : results.questionnaires) {
    if (one.instrument != claim.instrument) continue;
    for (const ScalePair& pair : one.pairs) {
      const Comparison& test = pair.comparison;
      const bool turned = test.a == b && test.b == a;
      if (pair.name != claim.measure || (!turned && (test.a != a || test.b != b))) continue;
      rows.push_back(row_of(claim));
      fill(results, claim, test, turned, a, b, rows.back());
    }
  }
  return rows;
}

}  // namespace

void add_printed_tests(const Results& results, Published& published) {
  for (const PrintedTest& printed : published.study->tests) {
    published.rows.push_back(row_of(results, printed));
  }
}

void add_printed_claims(const Results& results, Published& published) {
  for (const PrintedClaim& claim : published.study->claims) {
    const int a = interface_of_type(results, claim.a);
    const int b = interface_of_type(results, claim.b);
    auto rows = claim.instrument.empty() ? by_trials(results, claim, a, b)
                                         : by_answers(results, claim, a, b);
    if (rows.empty()) {
      rows.push_back(row_of(claim));
      rows.back().note = "This run has no values of it.";
    }
    for (PublishedRow& row : rows) published.rows.push_back(std::move(row));
  }
}

void add_printed_preference(const Results& results, Published& published) {
  const auto& printed = published.study->preference;
  if (!printed) return;
  PublishedRow row;
  row.kind = "preference";
  row.what = fmt::format("would rather use: {}", printed->type);
  row.place = std::string(printed->place);
  row.printed = printed->p;
  row.printed_words =
      fmt::format("{} of {} ({:.0f} %, 95 % CI {:.1f} to {:.1f} %), p {}", printed->chosen,
                  printed->answers, 100.0 * printed->chosen / printed->answers,
                  100 * printed->lower, 100 * printed->upper, p_text(printed->p));
  const Preference& run = results.preference;
  const int index = interface_of_type(results, printed->type);
  if (run.n > 0 && index >= 0 && run.pairs.size() == 1) {
    const int chosen = item(run.counts, index);
    const Interval& ci = item(run.intervals, index);
    const double p = run.pairs[0].p;
    row.n = run.n;
    row.run = p;
    row.p_exact = p;
    row.run_words =
        fmt::format("{} of {} ({:.0f} %, 95 % CI {:.1f} to {:.1f} %), p {}", chosen, run.n,
                    100.0 * chosen / run.n, 100 * ci.lower, 100 * ci.upper, p_text(p));
    row.agrees = p < level && 2 * chosen > run.n;
  } else {
    row.note = "Nobody was asked to choose between these two.";
  }
  published.rows.push_back(std::move(row));
}

}  // namespace promenade::analysis
