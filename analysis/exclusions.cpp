#include "analysis/exclusions.h"

#include <algorithm>

#include "analysis/item.h"
#include "motion/did_you_mean.h"
#include "motion/problem.h"
#include "study/csv.h"

namespace promenade::analysis {
namespace {

using Member = std::string Exclusion::*;

struct Column {
  const char* name;
  Member member;
};
constexpr Column columns[] = {{"code", &Exclusion::code},
                              {"reason", &Exclusion::reason},
                              {"rule", &Exclusion::rule},
                              {"date", &Exclusion::date}};

std::string trimmed(const std::string& text) {
  const char* spaces = " \t\r";
  const std::size_t first = text.find_first_not_of(spaces);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool is_heading(const study::CsvRow& row) {
  return std::any_of(row.cells.begin(), row.cells.end(),
                     [](const std::string& cell) { return lower(trimmed(cell)) == "code"; });
}

// YYYY-MM-DD, with digits where they belong.
bool is_date(const std::string& text) {
  constexpr std::string_view pattern = "0000-00-00";
  if (text.size() != pattern.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool digit = text[i] >= '0' && text[i] <= '9';
    if (pattern[i] == '0' ? !digit : text[i] != '-') return false;
  }
  return true;
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  void read(const study::CsvRow& row) {
    if (row.cells.size() == 1 && trimmed(row.cells[0]).empty()) return;
    if (row.line == 1 && is_heading(row)) return read_heading(row);
    if (size_of(row.cells) > size_of(members_)) {
      return complain(row, members_.size(), "want " + wanted() + " here");
    }
    Exclusion exclusion;
    exclusion.line = row.line;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (members_[i]) exclusion.*members_[i] = trimmed(row.cells[i]);
    }
    if (exclusion.code.empty()) return complain(row, 0, "want " + wanted() + " here");
    if (!exclusion.date.empty() && !is_date(exclusion.date)) {
      return complain(row, place_of(&Exclusion::date), "want a date as 2026-11-29 here");
    }
    exclusions_.push_back(std::move(exclusion));
  }

  std::vector<Exclusion> take() {
    if (!problems_.empty()) throw InputError(std::move(problems_));
    return std::move(exclusions_);
  }

 private:
  void read_heading(const study::CsvRow& row) {
    members_.assign(row.cells.size(), nullptr);
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string name = lower(trimmed(row.cells[i]));
      const auto* found = std::find_if(std::begin(columns), std::end(columns),
                                       [&](const Column& one) { return one.name == name; });
      if (found == std::end(columns)) {
        std::vector<std::string> names;
        for (const Column& one : columns) names.emplace_back(one.name);
        complain(row, i, "no such column: \"" + name + "\"" + did_you_mean(name, names));
      } else if (std::count(members_.begin(), members_.end(), found->member) > 0) {
        complain(row, i, "the column \"" + name + "\" stands here twice");
      } else {
        members_[i] = found->member;
      }
    }
  }

  std::string wanted() const {
    std::string names;
    for (const Member member : members_) {
      for (const Column& one : columns) {
        if (one.member != member) continue;
        std::string name = one.name;
        for (char& c : name) c = static_cast<char>(c - 'a' + 'A');
        names += (names.empty() ? "" : ",") + name;
      }
    }
    return names;
  }

  std::size_t place_of(Member member) const {
    return static_cast<std::size_t>(std::find(members_.begin(), members_.end(), member) -
                                    members_.begin());
  }

  void complain(const study::CsvRow& row, std::size_t cell, const std::string& what) {
    const Place place = row.place(cell);
    problems_.push_back({file_, place.line, place.column, what, Severity::error});
  }

  const std::string& file_;
  std::vector<Member> members_ = {&Exclusion::code, &Exclusion::reason};
  std::vector<Exclusion> exclusions_;
  std::vector<Problem> problems_;
};

}  // namespace

std::vector<Exclusion> parse_exclusions(const std::string& file, std::string_view text) {
  Reader reader(file);
  for (const study::CsvRow& row : study::parse_csv(text)) reader.read(row);
  return reader.take();
}

std::string exclusions_csv(const std::vector<Exclusion>& exclusions) {
  std::string text = study::csv_line({"code", "reason", "rule", "date"});
  for (const Exclusion& one : exclusions) {
    text += study::csv_line({one.code, one.reason, one.rule, one.date});
  }
  return text;
}

}  // namespace promenade::analysis
