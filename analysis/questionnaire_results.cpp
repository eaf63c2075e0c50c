#include "analysis/questionnaire_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "analysis/item.h"
#include "analysis/statistics/median.h"

namespace promenade::analysis {
namespace {

using study::Instrument;
using study::ItemKind;
using Pages = std::vector<const FilledPage*>;

std::optional<double> value_of(const FilledPage& page, const std::string& name) {
  const auto found = page.answers.find(name);
  if (found == page.answers.end() || !std::isfinite(found->second.value.value_or(0))) return {};
  return found->second.value;
}

// The mean of what each person gave; `number` takes one page.
template <typename Function>
PersonValues means(const Pages& pages, std::size_t people, const Function& number) {
  std::vector<double> sum(people, 0.0);
  std::vector<int> count(people, 0);
  for (const FilledPage* page : pages) {
    const std::optional<double> value = number(*page);
    if (!value || !std::isfinite(*value)) continue;
    item(sum, page->person) += *value;
    ++item(count, page->person);
  }
  PersonValues values(people);
  for (std::size_t i = 0; i < people; ++i) {
    if (count[i] > 0) values[i] = sum[i] / count[i];
  }
  return values;
}

// Does a score weigh its items alike, so that alpha is about it?
bool is_plain(const study::Score& score) {
  return score.items.size() > 1 &&
         std::all_of(score.items.begin(), score.items.end(),
                     [](const study::ScoreItem& one) { return one.weight.empty(); });
}

// What one instrument gave at one moment.
class Maker {
 public:
  Maker(const Pages& pages, const Instrument* instrument, const Dataset& data)
      : instrument_(instrument), people_(data.people.size()), interfaces_(data.interfaces) {
    result_.instrument = pages[0]->instrument;
    result_.version = pages[0]->version;
    result_.asked = pages[0]->asked;
    result_.pages = size_of(pages);
    std::set<int> people;
    for (const FilledPage* page : pages) {
      people.insert(page->person);
      by_interface_[index_of(page->interface)].push_back(page);
      for (const auto& [name, answer] : page->answers) result_.declined += answer.declined ? 1 : 0;
    }
    result_.people = size_of(people);
  }

  QuestionnaireResult make() {
    result_.is_known = instrument_ != nullptr;
    if (!instrument_) return std::move(result_);
    result_.citation = instrument_->citation;
    for (const study::Score& score : instrument_->scores) add_score(score);
    for (const study::Item& one : instrument_->items) add_item(one);
    return std::move(result_);
  }

 private:
  int index_of(const std::string& interface) const {
    const auto found = std::find(interfaces_.begin(), interfaces_.end(), interface);
    return found == interfaces_.end() ? -1 : static_cast<int>(found - interfaces_.begin());
  }

  void add_score(const study::Score& score) {
    add_scale(score.name, true,
              [&](const FilledPage& page) { return score_of_page(page, *instrument_, score); });
    if (!is_plain(score)) return;
    for (const auto& [interface, pages] : by_interface_) add_alpha(score, interface, pages);
  }

  void add_item(const study::Item& one) {
    switch (one.kind) {
      case ItemKind::scale:
      case ItemKind::number:
        return add_scale(one.name, false,
                         [&](const FilledPage& page) { return value_of(page, one.name); });
      case ItemKind::choice:
      case ItemKind::agree:
        for (const auto& [interface, pages] : by_interface_) add_choices(one, interface, pages);
        return;
      case ItemKind::ranking:
        return add_ranks(one);
      case ItemKind::text:
        return add_texts(one);
    }
  }

  template <typename Function>
  void add_scale(const std::string& name, bool is_score, const Function& number) {
    std::vector<PersonValues> values(interfaces_.size());
    for (const auto& [interface, pages] : by_interface_) {
      ScaleResult scale;
      scale.name = name;
      scale.is_score = is_score;
      scale.interface = interface;
      scale.values = means(pages, people_, number);
      const std::vector<double> given = present(scale.values);
      scale.moments = moments_of(given);
      scale.median = median_of(given);
      scale.median_ci = median_interval(given, 0.95);
      if (interface >= 0) item(values, interface) = scale.values;
      if (!given.empty()) result_.scales.push_back(std::move(scale));
    }
    if (is_score || instrument_->scores.empty()) add_pairs(name, std::move(values));
  }

  // Answers about single trials, the scores apart, are measures of the trials already.
  void add_pairs(const std::string& name, std::vector<PersonValues> values) {
    const bool is_measure = result_.asked == "trial" && instrument_->scores.empty();
    if (by_interface_.rbegin()->first < 0 || is_measure) return;
    for (PersonValues& one : values) one.resize(people_);
    Comparison place;
    place.pooling = Pooling::participants;
    for (Comparison& pair : compare_pairs(place, values)) {
      if (pair.test.n > 0) result_.pairs.push_back({name, std::move(pair)});
    }
  }

  void add_alpha(const study::Score& score, int interface, const Pages& pages) {
    Pages whole;
    std::copy_if(pages.begin(), pages.end(), std::back_inserter(whole),
                 [&](const FilledPage* page) {
                   return std::all_of(score.items.begin(), score.items.end(), [&](const auto& one) {
                     return value_of(*page, one.item).has_value();
                   });
                 });
    std::vector<std::vector<double>> rows;
    std::vector<PersonValues> columns;
    for (const study::ScoreItem& one : score.items) {
      columns.push_back(
          means(whole, people_, [&](const FilledPage& page) { return turned(page, one); }));
    }
    for (std::size_t person = 0; person < people_; ++person) {
      if (!columns[0][person]) continue;
      std::vector<double> row;
      for (const PersonValues& column : columns) row.push_back(*column[person]);
      rows.push_back(std::move(row));
    }
    if (!rows.empty()) result_.alphas.push_back({score.name, interface, cronbach_alpha(rows)});
  }

  // What asks for the opposite is turned round.
  std::optional<double> turned(const FilledPage& page, const study::ScoreItem& one) const {
    const std::optional<double> value = value_of(page, one.item);
    if (!value || !one.reversed) return value;
    const study::Item& asked = *study::find_item(*instrument_, one.item);
    return asked.least + asked.most - *value;
  }

  void add_choices(const study::Item& asked, int interface, const Pages& pages) {
    std::vector<ChoiceCount> counts;
    if (asked.kind == ItemKind::agree) counts.push_back({asked.name, "agreed", interface});
    for (const study::Choice& choice : asked.choices) {
      counts.push_back({asked.name, choice.name, interface});
    }
    counts.push_back({asked.name, "", interface});
    int answers = 0;
    for (const FilledPage* page : pages) {
      const auto found = page->answers.find(asked.name);
      if (found == page->answers.end() || found->second.declined) continue;
      ++answers;
      const bool agreed = asked.kind == ItemKind::agree && found->second.value.value_or(0) == 1;
      const std::string chosen = agreed ? "agreed" : choice_of(asked, found->second);
      const auto known = std::find_if(counts.begin(), counts.end(), [&](const ChoiceCount& one) {
        return !one.choice.empty() && one.choice == chosen;
      });
      ++(known == counts.end() ? counts.back() : *known).count;
    }
    if (counts.back().count == 0) counts.pop_back();
    for (ChoiceCount& one : counts) {
      one.answers = answers;
      one.is_pair = asked.pair;
      if (answers > 0) result_.choices.push_back(one);
    }
  }

  // By its name, else by its place, from 1.
  static std::string choice_of(const study::Item& asked, const study::ItemAnswer& answer) {
    const double place = answer.value.value_or(0);
    const bool named = !answer.text.empty() || !(place >= 1 && place <= size_of(asked.choices));
    return named ? answer.text : item(asked.choices, static_cast<int>(place) - 1).name;
  }

  void add_ranks(const study::Item& asked) {
    for (const study::Choice& choice : asked.choices) {
      RankResult rank{asked.name, choice.name, 0, 0, std::vector<int>(asked.choices.size(), 0)};
      for (const auto& [interface, pages] : by_interface_) {
        for (const FilledPage* page : pages) {
          const int place =
              static_cast<int>(value_of(*page, asked.name + ":" + choice.name).value_or(0));
          if (place < 1 || place > size_of(rank.counts)) continue;
          ++rank.n;
          rank.mean_rank += place;
          ++item(rank.counts, place - 1);
        }
      }
      if (rank.n == 0) continue;
      rank.mean_rank /= rank.n;
      result_.ranks.push_back(std::move(rank));
    }
  }

  void add_texts(const study::Item& asked) {
    TextCount count{asked.name, 0};
    for (const auto& [interface, pages] : by_interface_) {
      for (const FilledPage* page : pages) {
        const auto found = page->answers.find(asked.name);
        count.texts += found != page->answers.end() && !found->second.text.empty() ? 1 : 0;
      }
    }
    result_.texts.push_back(count);
  }

  const Instrument* instrument_;
  std::size_t people_;
  const std::vector<std::string>& interfaces_;
  std::map<int, Pages> by_interface_;  // -1: about none
  QuestionnaireResult result_;
};

bool is_about_known_interface(const FilledPage& page, const Dataset& data) {
  return page.interface.empty() || std::find(data.interfaces.begin(), data.interfaces.end(),
                                             page.interface) != data.interfaces.end();
}

}  // namespace

std::vector<QuestionnaireResult> questionnaire_results(const std::vector<FilledPage>& pages,
                                                       const std::vector<Instrument>& instruments,
                                                       const Dataset& data) {
  std::map<std::array<std::string, 3>, Pages> groups;
  for (const FilledPage& page : pages) {
    if (!is_about_known_interface(page, data)) continue;
    groups[{page.instrument, page.version, page.asked}].push_back(&page);
  }
  std::vector<QuestionnaireResult> results;
  for (const auto& [key, group] : groups) {
    const Instrument* instrument = find_instrument(instruments, key[0], key[1]);
    results.push_back(Maker(group, instrument, data).make());
  }
  return results;
}

}  // namespace promenade::analysis
