#include "analysis/vectors.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "analysis/families/family.h"
#include "motion/problem.h"

namespace promenade::analysis {
namespace {

using families::CaseError;
using families::Json;

struct Family {
  std::string_view name;
  Json (*run)(const Json& input);
};

constexpr auto table = std::to_array<Family>({
    {"wilcoxon", families::wilcoxon},
    {"hodges_lehmann", families::hodges_lehmann},
    {"wilson", families::wilson},
    {"clopper_pearson", families::clopper_pearson},
    {"p_adjust", families::p_adjust},
    {"mcnemar", families::mcnemar},
    {"sign_test", families::sign_test},
    {"cochran_q", families::cochran_q},
    {"friedman", families::friedman},
    {"kaplan_meier", families::kaplan_meier},
    {"logrank", families::logrank},
    {"cronbach_alpha", families::cronbach_alpha},
    {"icc", families::icc},
    {"krippendorff_alpha", families::krippendorff_alpha},
    {"bootstrap_median_ideal", families::bootstrap_median_ideal},
    {"bootstrap_ci_given_replicates", families::bootstrap_ci_given_replicates},
    {"power_signflip_exact", families::power_signflip_exact},
    {"power_simulated", families::power_simulated},
    {"power_paired_t", families::power_paired_t},
    {"ward", families::ward},
    {"pca", families::pca},
    {"classical_mds", families::classical_mds},
});

// Line and column of a byte, both from 1.
Problem problem_at(const std::string& file, std::string_view text, std::size_t byte,
                   std::string message) {
  const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n') + 1;  // 0 when there is none
  return {file, static_cast<int>(lines) + 1, static_cast<int>(before.size() - start) + 1,
          std::move(message), Severity::error};
}

// Is it the beginning of a number that no double can hold? Then where it ends, else 0.
std::size_t end_of_huge_number(std::string_view text) {
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view word = text.substr(0, static_cast<std::size_t>(stop - text.data()));
  const std::size_t exponent = word.find_first_of("eE");
  const bool tiny =
      exponent != word.npos ? word.find('-', exponent) != word.npos : word.find("0.") <= 1;
  return error == std::errc::result_out_of_range && !tiny ? word.size() : 0;
}

// The same document with such numbers as texts, which the cases that hold them refuse.
struct Quoted {
  std::string text;
  std::vector<std::size_t> quotes;  // where in it one was added

  // Where a byte of it, counted from 1, was before.
  std::size_t before(std::size_t byte) const {
    const auto added = std::lower_bound(quotes.begin(), quotes.end(), byte);
    return byte - static_cast<std::size_t>(added - quotes.begin());
  }
};

Quoted with_huge_numbers_quoted(std::string_view text) {
  Quoted result;
  const auto quote = [&result] {
    result.quotes.push_back(result.text.size());
    result.text += '"';
  };
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    const bool begins_number = (letter >= '0' && letter <= '9') || letter == '-';
    const std::size_t end = !in_text && begins_number ? end_of_huge_number(text.substr(i)) : 0;
    if (letter == '"') in_text = !in_text;
    if (end > 0) {
      quote();
      result.text += text.substr(i, end);
      quote();
      i += end - 1;
      continue;
    }
    result.text += letter;
    if (in_text && letter == '\\' && i + 1 < text.size()) result.text += text[++i];
  }
  return result;
}

Json parse_quoted(const std::string& file, std::string_view text) {
  const Quoted quoted = with_huge_numbers_quoted(text);
  try {
    return Json::parse(quoted.text);
  } catch (const Json::exception& error) {
    const auto* where = dynamic_cast<const Json::parse_error*>(&error);
    const std::size_t byte = where ? quoted.before(where->byte) : 1;
    throw InputError({problem_at(file, text, byte, "is not JSON here")});
  }
}

Json parse(const std::string& file, std::string_view text) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw InputError({problem_at(file, text, error.byte, "is not JSON here")});
  } catch (const Json::out_of_range&) {
    return parse_quoted(file, text);
  }
}

Json error_entry(const std::string& message) { return {{"error", message}}; }

Json run_case(const std::string& family, const Json& one) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const Family& known) { return known.name == family; });
  if (found == table.end()) return error_entry("the family " + family + " is not known");
  const auto input = one.find("input");
  if (input == one.end() || !input->is_object()) return error_entry("the case has no input");
  try {
    return found->run(*input);
  } catch (const CaseError& error) {
    return error_entry(error.what());
  }
}

// An entry under the place of a case, since there is no id to put it under.
void put_error(Json& results, std::string place, const std::string& message) {
  while (results.contains(place)) place += '_';
  results[place] = error_entry(message);
}

// Runs the cases of one family into results.
void run_family(const std::string& family, const Json& cases, Json& results) {
  if (!cases.is_array()) return put_error(results, "family " + family, "is not a list of cases");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Json& one = cases[i];
    const std::string place = "case " + std::to_string(i) + " of family " + family;
    const auto id = one.is_object() ? one.find("id") : one.end();
    if (id == one.end() || !id->is_string()) {
      put_error(results, place, "the case has no id");
    } else if (results.contains(id->get<std::string>())) {
      put_error(results, place, "the id " + id->get<std::string>() + " is that of an earlier case");
    } else {
      results[id->get<std::string>()] = run_case(family, one);
    }
  }
}

}  // namespace

std::string run_vectors(const std::string& file, std::string_view text) {
  const Json vectors = parse(file, text);
  const auto families = vectors.is_object() ? vectors.find("families") : vectors.end();
  if (families == vectors.end() || !families->is_object()) {
    throw InputError(file, "has no object \"families\"; it is not a file of test vectors");
  }
  Json results = Json::object();
  for (const auto& [family, cases] : families->items()) run_family(family, cases, results);
  return Json{{"results", std::move(results)}}.dump(1) + "\n";
}

std::vector<std::string> known_families() {
  std::vector<std::string> names;
  for (const Family& family : table) names.emplace_back(family.name);
  return names;
}

}  // namespace promenade::analysis
