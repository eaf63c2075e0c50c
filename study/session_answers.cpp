// Questionnaires: what was answered so far on this page, and what is stored of it.
#include <algorithm>
#include <cassert>

#include "study/lines.h"
#include "study/session_steps.h"

namespace promenade::study {
namespace {

using When = Questionnaire::When;

// A ranking is one row for each place.
void add_ranks(const Answer& whole, const std::string& names, std::vector<Record>& records) {
  int rank = 0;
  for (const std::string& name : lines_of(names)) {
    Answer one = whole;
    one.item += ":" + name;
    one.value = ++rank;
    one.text.clear();
    records.emplace_back(std::move(one));
  }
}

}  // namespace

bool Session::answered() const {
  const Instrument* asked = questions();
  if (asked == nullptr) return true;
  for (std::size_t i = 0; i < asked->items.size(); ++i) {
    if (asked->items[i].needed && !answers_[i].given()) return false;
  }
  return true;
}

void Session::Steps::open_questions() {
  const Instrument* asked = session.questions();
  const std::size_t count = asked == nullptr ? 0 : asked->items.size();
  session.answers_.assign(count, {});
  session.answered_us_.assign(count, 0);
  session.item_order_.clear();
  if (asked == nullptr) return;
  Rng rng(session.plan_.seed, session.page_, "items");
  session.item_order_ = study::item_order(*asked, rng);
  fill_in();
}

void Session::Steps::emit_answers() {
  const Instrument* asked = session.questions();
  if (asked == nullptr) return;
  const Page& page = session.page();
  Answer common;
  common.instrument = asked->name;
  common.version = asked->version;
  common.when =
      page.kind == PageKind::trial
          ? When::trial
          : session.bundle_->study.questionnaires[static_cast<std::size_t>(page.questionnaire)]
                .when;
  (common.when == When::trial ? common.trial : common.about) = page.trial;
  for (std::size_t place = 0; place < session.item_order_.size(); ++place) {
    const auto i = static_cast<std::size_t>(session.item_order_[place]);
    const ItemAnswer& given = session.answers_[i];
    Answer answer = common;
    answer.place = static_cast<int>(place) + 1;
    answer.touched = given.given();
    answer.t_us = answer.touched ? session.answered_us_[i] : input.t_us;
    answer.item = asked->items[i].name;
    answer.value = given.value;
    answer.text = given.text;
    answer.declined = given.declined;
    const bool ranks = asked->items[i].kind == ItemKind::ranking && !given.text.empty();
    if (ranks) {
      add_ranks(answer, given.text, records);
    } else {
      records.emplace_back(std::move(answer));
    }
  }
}

void Session::Steps::act(const SetAnswer& set) {
  const Instrument* asked = session.questions();
  if (asked == nullptr) return;
  for (std::size_t i = 0; i < asked->items.size(); ++i) {
    const ItemAnswer answer{set.value, set.text, set.declined};
    if (asked->items[i].name != set.item) continue;
    if (answer.given() && !allows(asked->items[i], answer)) continue;
    session.answers_[i] = answer;
    session.answered_us_[i] = input.t_us;
    Event& event = log("answer");
    event.target = set.item;
    event.value = set.value;
    if (!set.text.empty()) event.detail = json_text("text", set.text);
    if (set.declined) event.detail = R"({"declined":true})";
  }
}

}  // namespace promenade::study
