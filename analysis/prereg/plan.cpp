#include "analysis/prereg/plan.h"

#include <algorithm>

#include "motion/did_you_mean.h"
#include "study/study.h"
#include "study/toml_reader.h"

namespace promenade::analysis {
namespace {

using study::TomlReader;
using study::TomlTable;
using study::TomlText;
using study::TomlValue;

using Names = std::vector<std::string>;

// The names that a plan may use; without a study any will do.
struct KnownNames {
  bool checked = false;
  Names measures, tasks, interfaces;
};

KnownNames names_of(const study::Study* study) {
  KnownNames names;
  if (!study) return names;
  names.checked = true;
  for (const Measure& one : measures_of(*study)) names.measures.push_back(one.name);
  for (const study::Task& one : study->tasks) {
    if (one.kind != study::TaskKind::rate) names.tasks.push_back(one.name);
  }
  for (const study::InterfaceUse& one : study->interfaces) names.interfaces.push_back(one.name);
  return names;
}

std::string known_name(const TomlTable& table, const char* key, bool checked, const Names& known,
                       const char* what) {
  std::string name = table.required_text(key);
  if (name.empty() || !checked || std::find(known.begin(), known.end(), name) != known.end()) {
    return name;
  }
  const std::string meant = did_you_mean(name, known);
  table.error(key, "the study has no " + std::string(what) + " \"" + name + "\"" +
                       (meant.empty() ? "; it has " + quoted_list(known) : meant));
  return name;
}

std::vector<PlannedPair> read_pairs(const TomlTable& table, const KnownNames& names) {
  std::vector<PlannedPair> pairs;
  if (table.is("pairs", TomlValue::Kind::text)) {
    table.choice("pairs", {"all"});
    return pairs;
  }
  for (const TomlTable& one : table.tables("pairs")) {
    PlannedPair pair{known_name(one, "a", names.checked, names.interfaces, "interface"),
                     known_name(one, "b", names.checked, names.interfaces, "interface")};
    if (!pair.a.empty() && pair.a == pair.b) one.error("a pair has two different interfaces");
    pairs.push_back(std::move(pair));
  }
  if (table.is("pairs", TomlValue::Kind::array) && pairs.empty()) {
    table.error("pairs", "names no pair; write \"all\", or leave it out, for all pairs");
  }
  return pairs;
}

void refuse_double_measures(const std::vector<TomlTable>& tables,
                            const std::vector<PlannedMeasure>& measures) {
  for (std::size_t i = 0; i < measures.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (measures[i].measure.empty() || measures[i].measure != measures[j].measure ||
          measures[i].task != measures[j].task) {
        continue;
      }
      tables[i].error("\"" + measures[i].measure + "\" in \"" + measures[i].task +
                      "\" stands above already; name all its pairs there");
    }
  }
}

std::vector<PlannedMeasure> read_measures(const TomlTable& root, const KnownNames& names) {
  root.require("measure");
  const std::vector<TomlTable> tables = root.tables("measure");
  std::vector<PlannedMeasure> measures;
  for (const TomlTable& one : tables) {
    measures.push_back({known_name(one, "name", names.checked, names.measures, "measure"),
                        known_name(one, "task", names.checked, names.tasks, "task"),
                        read_pairs(one, names)});
  }
  refuse_double_measures(tables, measures);
  return measures;
}

std::vector<std::string> read_sentences(const TomlTable& table, const char* key) {
  std::vector<std::string> sentences;
  for (const TomlText& one : table.texts(key)) {
    if (one.text.find_first_not_of(" \t\r\n") == std::string::npos) {
      table.reader().add(one.place, "is empty; say it in a sentence");
    }
    sentences.push_back(one.text);
  }
  return sentences;
}

ExclusionRules read_exclusions(const TomlTable& root) {
  ExclusionRules rules;
  const auto table = root.table("exclusions");
  if (!table) return rules;
  rules.words = read_sentences(*table, "words");
  if (const auto least = table->integer("min_trials", 1, 100'000)) {
    rules.min_trials = static_cast<int>(*least);
  }
  rules.max_flagged_share = table->number("max_flagged_share", 0, 1);
  return rules;
}

void require_hypothesis(const TomlTable& root, const AnalysisPlan& plan) {
  root.require("hypotheses");
  if (root.is("hypotheses", TomlValue::Kind::array) && plan.hypotheses.empty()) {
    root.error("hypotheses", "names no hypothesis; say in a sentence what you expect");
  }
}

}  // namespace

std::vector<Measure> measures_of(const study::Study& study) {
  std::vector<std::string> items;
  for (const study::Questionnaire& one : study.questionnaires) {
    if (one.when != study::Questionnaire::When::trial) continue;
    const auto& instrument = study.instruments[static_cast<std::size_t>(one.instrument)];
    for (const study::Item& item : instrument.items) {
      if (std::find(items.begin(), items.end(), item.name) == items.end()) {
        items.push_back(item.name);
      }
    }
  }
  return measures_with(items);
}

AnalysisPlan read_plan(const std::string& file, std::string_view text, const study::Study* study) {
  TomlReader reader(file, text);
  if (!reader.parsed()) reader.finish();
  const TomlTable root = reader.root();
  const KnownNames names = names_of(study);
  AnalysisPlan plan;
  plan.hypotheses = read_sentences(root, "hypotheses");
  require_hypothesis(root, plan);
  plan.measures = read_measures(root, names);
  plan.exclusions = read_exclusions(root);
  if (root.choice("family", {"measure", "all"}) == "all") plan.family = HolmFamily::all;
  plan.alpha = root.number("alpha", 1e-6, 0.5).value_or(plan.alpha);
  root.require("participants");
  plan.participants = static_cast<int>(root.integer("participants", 1, 100'000).value_or(0));
  plan.stopping = root.required_text("stopping");
  root.choice("pooling", {"participants"});
  reader.finish();
  return plan;
}

}  // namespace promenade::analysis
