#include "study/adjective_model_file.h"

#include <algorithm>
#include <optional>

#include "motion/did_you_mean.h"
#include "study/ratings_csv.h"
#include "study/study_parts.h"

namespace promenade::study {
namespace {

constexpr const char* kind = "adjective model";
constexpr int version = 1;

std::string english(const LocalText& text) {
  const auto found = text.find("en");
  return found == text.end() ? "" : found->second;
}

class Reader {
 public:
  Reader(const std::string& file, std::string_view text)
      : text_(text), reader_(file, text), root_(reader_.root()) {}

  AdjectiveModel read(const std::vector<std::string>& motions) {
    if (!reader_.parsed()) reader_.finish();
    read_head();
    const motion::QuantificationOptions options = read_options();
    const std::vector<std::string> own = read_motions();
    const auto tables = root_.tables("primary");
    std::vector<PrimaryWords> words = read_words(tables);
    auto table = read_table(own);
    if (table && !motions.empty()) compare_motions(table->motions, motions);
    std::optional<AdjectiveModel> model;
    if (table) {
      table->simulated = table->simulated || simulated_;
      model = make_adjective_model(std::move(*table), source_, options);
    }
    compare(tables, model);
    reader_.finish();
    if (!model) throw InputError(reader_.file(), "holds no ratings");
    AdjectiveModel result = named(std::move(*model), std::move(words));
    return motions.empty() ? result : reordered(std::move(result), motions);
  }

 private:
  void read_head() {
    if (const auto found = root_.text("kind"); found && *found != kind)
      root_.error("kind", "this is no " + std::string(kind));
    root_.require("kind");
    root_.require("version");
    root_.integer("version", version, version);
    root_.require("simulated");
    simulated_ = root_.boolean("simulated").value_or(false);
    source_ = root_.text("source").value_or(reader_.file());
  }
  motion::QuantificationOptions read_options() {
    motion::QuantificationOptions options;
    options.least_extreme = root_.number("least_extreme", 0, 2).value_or(options.least_extreme);
    options.most_deviation = root_.number("most_deviation", 0, 4).value_or(options.most_deviation);
    options.clusters = static_cast<int>(root_.integer("clusters", 1, 100).value_or(4));
    options.flip = root_.boolean("flip").value_or(false);
    return options;
  }
  std::vector<std::string> read_motions() {
    std::vector<std::string> motions;
    for (const TomlText& one : root_.texts("motions")) {
      if (std::find(motions.begin(), motions.end(), one.text) != motions.end())
        reader_.add(one.place, "the motion \"" + one.text + "\" is named twice");
      motions.push_back(one.text);
    }
    return motions;
  }
  static std::vector<PrimaryWords> read_words(const std::vector<TomlTable>& tables) {
    std::vector<PrimaryWords> all;
    std::vector<std::string> names;
    for (const TomlTable& table : tables) {
      PrimaryWords words;
      table.require("name");
      words.name = read_local_text(table, "name", std::vector<std::string>());
      words.low = read_local_text(table, "low", std::vector<std::string>());
      words.high = read_local_text(table, "high", std::vector<std::string>());
      const std::string name = english(words.name);
      if (table.has("name")) check_name(table, name, names);
      names.push_back(name);
      all.push_back(std::move(words));
    }
    return all;
  }
  static void check_name(const TomlTable& table, const std::string& name,
                         const std::vector<std::string>& before) {
    if (name.empty()) return table.error("name", "\"name\" needs English words, for the log");
    refuse_unsafe_name(table, "name", name);
    if (std::find(before.begin(), before.end(), name) != before.end())
      table.error("name", "there is another slider with the name \"" + name + "\" before");
  }
  std::optional<RatingsTable> read_table(const std::vector<std::string>& motions) {
    root_.require("ratings");
    const auto section = root_.table("ratings");
    if (!section) return std::nullopt;
    section->require("table");
    const auto csv = section->text("table");
    if (!csv) return std::nullopt;
    try {
      return read_ratings_csv(reader_.file(), *csv, motions);
    } catch (const InputError& error) {
      for (const Problem& problem : error.problems()) add_inner(*section, problem);
      return std::nullopt;
    }
  }
  void compare_motions(const std::vector<std::string>& own,
                       const std::vector<std::string>& motions) {
    const auto missing = [](const std::vector<std::string>& names, const std::string& name) {
      return std::find(names.begin(), names.end(), name) == names.end();
    };
    const char* const key = root_.has("motions") ? "motions" : "ratings";
    for (const std::string& name : own) {
      if (missing(motions, name))
        root_.error(key, "the set has no motion \"" + name + "\"" + did_you_mean(name, motions));
    }
    for (const std::string& name : motions) {
      if (missing(own, name)) root_.error(key, "there is no rating of \"" + name + "\"");
    }
  }
  // A problem inside the table, at its place in the file if the table begins on a line of its own.
  void add_inner(const TomlTable& section, const Problem& problem) {
    const Place place = section.place("table");
    if (problem.line == 0 || !opens_block(place.line))
      return section.error("table", problem.message);
    reader_.add({{reader_.file(), place.line + problem.line, problem.column, problem.message,
                  Severity::error}});
  }
  bool opens_block(int line) const {
    std::size_t begin = 0;
    for (int i = 1; i < line && begin != std::string_view::npos; ++i) {
      begin = text_.find('\n', begin);
      if (begin != std::string_view::npos) ++begin;
    }
    if (begin == std::string_view::npos) return false;
    std::string_view rest = text_.substr(begin, text_.find('\n', begin) - begin);
    if (rest.ends_with('\r')) rest.remove_suffix(1);
    return rest.ends_with("'''") || rest.ends_with("\"\"\"");
  }
  void compare(const std::vector<TomlTable>& tables, const std::optional<AdjectiveModel>& model) {
    if (model && tables.size() != model->names.size()) {
      root_.error("primary", "there are " + std::to_string(tables.size()) +
                                 " sliders, but the ratings give " +
                                 std::to_string(model->names.size()));
    }
    for (std::size_t c = 0; c < tables.size(); ++c) {
      std::vector<std::string> listed;
      for (const TomlText& one : tables[c].texts("pairs")) listed.push_back(one.text);
      if (!model || c >= model->names.size()) continue;
      compare_pairs(tables[c], listed, pairs_of(*model, static_cast<int>(c)));
      refuse_pair_as_name(tables[c], *model);
    }
  }
  static void compare_pairs(const TomlTable& table, std::vector<std::string> listed,
                            std::vector<std::string> found) {
    std::sort(listed.begin(), listed.end());
    std::sort(found.begin(), found.end());
    if (listed == found) return;
    table.error("pairs", "the ratings and thresholds give this slider the pairs " +
                             quoted_list(found) +
                             "; write the file anew with `promenade model adjectives`");
  }
  // Single pairs are sliders, too, under their own names.
  static void refuse_pair_as_name(const TomlTable& table, const AdjectiveModel& model) {
    const std::string name = english(read_local_text(table, "name", std::vector<std::string>()));
    const auto& pairs = model.table.pairs;
    if (std::find(pairs.begin(), pairs.end(), name) != pairs.end())
      table.error("name", "\"" + name + "\" is a pair of adjectives; give another name");
  }

  std::string_view text_;
  TomlReader reader_;
  TomlTable root_;
  std::string source_;
  bool simulated_ = false;
};

}  // namespace

AdjectiveModel read_adjective_model(const std::string& file, std::string_view text,
                                    const std::vector<std::string>& motions) {
  return Reader(file, text).read(motions);
}

bool is_adjective_model(const std::string& file) { return file.ends_with(".toml"); }

}  // namespace promenade::study
