#include "analysis/export/export_published.h"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/export/export_parts.h"
#include "analysis/item.h"

namespace promenade::analysis {
namespace {

using study::Database;
using study::ItemKind;
using study::Statement;

struct StoredAnswer {
  std::int64_t id = 0;
  std::string session, person, instrument, version, item, asked;
  bool about_trial = false;
  study::ItemAnswer answer;
};

struct PublicPerson {
  std::string uuid, language;
  bool simulated = false, hidden = false;
  std::map<std::string, std::string> traits;  // by question
};

std::vector<StoredAnswer> stored_answers(Database& database) {
  Statement row(database,
                "SELECT answer.rowid, answer.session, session.participant, answer.instrument, "
                "answer.version, answer.item, " +
                    column_or(database, "answer", "asked", "NULL") +
                    ", answer.trial IS NOT NULL, answer.value, answer.text, answer.declined "
                    "FROM main.answer AS answer JOIN main.session AS session "
                    "ON session.uuid = answer.session JOIN temp.public_session "
                    "ON public_session.old = session.uuid "
                    "ORDER BY session.started_utc, session.uuid, answer.t_us");
  std::vector<StoredAnswer> answers;
  while (row.step()) {
    StoredAnswer one{row.integer(0), row.text(1), row.text(2),         row.text(3), row.text(4),
                     row.text(5),    row.text(6), row.integer(7) != 0, {}};
    if (!row.is_null(8)) one.answer.value = row.real(8);
    one.answer.text = row.text(9);
    one.answer.declined = row.integer(10) != 0;
    answers.push_back(std::move(one));
  }
  return answers;
}

std::vector<PublicPerson> public_people(Database& database) {
  Statement row(database,
                "SELECT old, min(language), max(simulated) FROM temp.public_person JOIN "
                "main.session ON participant = old GROUP BY old ORDER BY new");
  std::vector<PublicPerson> people;
  while (row.step()) people.push_back({row.text(0), row.text(1), row.integer(2) != 0, false, {}});
  return people;
}

// The name of a choice, whatever words the person found for it.
std::string choice_name(const study::Item& item, const study::ItemAnswer& answer) {
  if (answer.declined) return "(declined)";
  const auto count = static_cast<double>(item.choices.size());
  if (!answer.value || *answer.value < 1 || *answer.value > count) return "";
  return item.choices[static_cast<std::size_t>(*answer.value) - 1].name;
}

class Publisher {
 public:
  Publisher(Database& database, const std::vector<study::Instrument>& instruments,
            const ReviewedAnswers& reviewed)
      : database_(database),
        instruments_(instruments),
        reviewed_(reviewed),
        answers_(stored_answers(database)),
        people_(public_people(database)),
        insert_(database, "INSERT INTO temp.public_answer VALUES (?,?,?)") {
    for (PublicPerson& person : people_) person_of_[person.uuid] = &person;
  }

  PublishedAnswers publish() {
    collect_traits();
    hide_small_cells();
    for (const StoredAnswer& one : answers_) publish(one);
    return std::move(published_);
  }

 private:
  const study::Item* item_of(const StoredAnswer& one) const {
    const study::Instrument* known = find_instrument(instruments_, one.instrument, one.version);
    return known ? study::find_item(*known, one.item.substr(0, one.item.find(':'))) : nullptr;
  }
  static bool at_start(const StoredAnswer& one) {
    return one.asked.empty() ? !one.about_trial : one.asked == "start";
  }
  static bool is_trait(const StoredAnswer& one, const study::Item& item) {
    const bool demographic = at_start(one) || one.instrument == "demographics";
    return demographic && (item.kind == ItemKind::choice || item.kind == ItemKind::number);
  }
  static std::string trait_of(const study::Item& item, const study::ItemAnswer& answer) {
    if (item.kind == ItemKind::choice || answer.declined) return choice_name(item, answer);
    return answer.value ? ten_years(*answer.value) : "";
  }

  void collect_traits() {
    published_.questions = {"simulated"};
    std::set<std::string> languages;
    for (const PublicPerson& person : people_) languages.insert(person.language);
    if (languages.size() > 1) {
      published_.questions.emplace_back("language");
      for (PublicPerson& person : people_) person.traits["language"] = person.language;
    }
    for (const StoredAnswer& one : answers_) {
      const study::Item* item = item_of(one);
      if (!item || !is_trait(one, *item)) continue;
      const std::string question = one.instrument + "." + one.item;
      person_of_.at(one.person)->traits[question] = trait_of(*item, one.answer);
      std::vector<std::string>& known = published_.questions;
      if (std::find(known.begin(), known.end(), question) == known.end()) known.push_back(question);
    }
    std::sort(published_.questions.begin() + 1, published_.questions.end());
  }

  // Simulated people hide nobody.
  void hide_small_cells() {
    if (published_.questions.size() == 1) return;
    for (const bool simulated : {false, true}) {
      std::vector<PublicPerson*> group;
      std::vector<std::vector<std::string>> rows;
      for (PublicPerson& person : people_) {
        if (person.simulated != simulated) continue;
        group.push_back(&person);
        rows.push_back(row_of(person));
      }
      for (DemographicCell& cell : demographic_cells(rows)) {
        if (cell.suppressed) hide(cell, group);
        published_.cells.push_back(std::move(cell));
      }
    }
  }

  std::vector<std::string> row_of(const PublicPerson& person) const {
    std::vector<std::string> row = {person.simulated ? "1" : "0"};
    for (std::size_t i = 1; i < published_.questions.size(); ++i) {
      const auto found = person.traits.find(published_.questions[i]);
      row.push_back(found == person.traits.end() ? "" : found->second);
    }
    return row;
  }

  void hide(const DemographicCell& cell, const std::vector<PublicPerson*>& group) {
    Statement mark(database_, "UPDATE temp.public_person SET hidden = 1 WHERE old = ?");
    for (const int index : cell.people) {
      item(group, index)->hidden = true;
      mark.bind(1, item(group, index)->uuid).run();
    }
  }

  void publish(const StoredAnswer& one) {
    const study::Item* item = item_of(one);
    if (!item && at_start(one)) return;
    const bool trait = item && is_trait(one, *item);
    if (trait && person_of_.at(one.person)->hidden) return;
    const bool coarse = trait && item->kind == ItemKind::number;
    insert_.bind(1, one.id);
    insert_.bind(2, coarse ? std::nullopt : one.answer.value);
    const std::string text =
        coarse ? trait_of(*item, {one.answer.value, "", false}) : text_of(one, item);
    text.empty() ? insert_.bind_null(3) : insert_.bind(3, text);
    insert_.run();
  }

  std::string text_of(const StoredAnswer& one, const study::Item* item) {
    const std::string& text = one.answer.text;
    const std::string name = item && item->kind == ItemKind::choice
                                 ? choice_name(*item, {one.answer.value, "", false})
                                 : "";
    if (text.empty() || text == name) return text;
    if (reviewed_.count({one.session, one.instrument, one.item, text}) > 0) return text;
    ++published_.withheld_texts;
    return name;
  }

  Database& database_;
  const std::vector<study::Instrument>& instruments_;
  const ReviewedAnswers& reviewed_;
  std::vector<StoredAnswer> answers_;
  std::vector<PublicPerson> people_;
  std::map<std::string, PublicPerson*> person_of_;  // by uuid
  Statement insert_;
  PublishedAnswers published_;
};

}  // namespace

PublishedAnswers publish_answers(Database& database,
                                 const std::vector<study::Instrument>& instruments,
                                 const ReviewedAnswers& reviewed) {
  return Publisher(database, instruments, reviewed).publish();
}

}  // namespace promenade::analysis
