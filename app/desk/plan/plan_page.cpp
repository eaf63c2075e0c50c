// Plan: who gets what in which order, how balanced that is, how long it takes, and how many people
// are needed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/desk/column.h"
#include "app/desk/pages.h"
#include "app/desk/plan/plan_power.h"
#include "app/desk/readiness.h"
#include "app/number_box.h"
#include "app/registry.h"
#include "app/scroll_area.h"
#include "study/balance.h"
#include "study/session_length.h"

namespace promenade::app {
namespace {

constexpr int most_people = 500;
constexpr int timed_people = 5;

// All that the page shows, worked out in a thread.
struct Orders {
  std::shared_ptr<const study::StudyBundle> bundle;
  std::vector<std::vector<int>> blocks;  // of each person: interfaces in their order
  study::Balance balance;
  int round = 1;
};

std::shared_ptr<const Orders> make_orders(const std::shared_ptr<const study::StudyBundle>& bundle,
                                          int people, const std::stop_token& ended) {
  auto orders = std::make_shared<Orders>();
  orders->bundle = bundle;
  std::vector<study::Plan> plans;
  for (int i = 0; i < people && !ended.stop_requested(); ++i) {
    plans.push_back(study::make_plan(bundle->study, i));
    orders->blocks.push_back(study::block_order(plans.back()));
  }
  orders->balance = study::balance_of(bundle->study, plans);
  orders->round = study::round_of_design(bundle->study);
  return orders;
}

class PlanPage : public DeskPage {
 public:
  PlanPage(DeskServices& services, OpenStudy& study)
      : services_(services), study_(study), power_(services, study) {}

  void advance(std::int64_t now_us) override;
  void draw(const Ui& ui, const study::Texts& words, const Box& room) override;
  bool moves() const override { return work_.working() || timing_.working(); }
  const std::vector<std::string>& shown_words() const override { return shown_; }

 private:
  void begin();
  void draw_orders(const Ui& ui, const study::Texts& words, const Box& box);
  void draw_people(const Ui& ui, const study::Texts& words, Column& column);
  void draw_table(const Ui& ui, const study::Texts& words, Column& column,
                  const Eigen::MatrixXi& counts, const char* title, bool by_interface);
  const std::string& name(int interface) const;

  DeskServices& services_;
  OpenStudy& study_;
  PlanPower power_;
  NumberDraft people_{12};
  bool asked_ = false;                                // how many the study plans
  std::shared_ptr<const study::StudyBundle> bundle_;  // that is shown
  std::shared_ptr<const Orders> orders_;
  NewestWork<std::shared_ptr<const Orders>> work_;
  std::optional<study::SessionLength> length_;
  NewestWork<study::SessionLength> timing_;
  std::vector<std::string> shown_;
  float high_ = 0;  // of the right side, pixels, as it was drawn last
  std::int64_t now_us_ = 0;
};

const std::string& PlanPage::name(int interface) const {
  return orders_->bundle->study.interfaces[static_cast<std::size_t>(interface)].name;
}

void PlanPage::begin() {
  const auto bundle = study_.bundle();
  if (!bundle) return;
  if (!asked_) {
    asked_ = true;
    const int round = study::round_of_design(bundle->study);
    const int planned = bundle->study.participants;
    people_.value = std::min(most_people, planned > 0 ? planned : std::max(round, 12));
  }
  work_.start([bundle, people = people_.value](const std::stop_token& ended) {
    return make_orders(bundle, people, ended);
  });
}

void PlanPage::advance(std::int64_t now_us) {
  now_us_ = now_us;
  if (study_.bundle() != bundle_) {
    bundle_ = study_.bundle();
    orders_.reset();
    length_.reset();
    begin();
    if (const auto bundle = study_.bundle()) {
      timing_.start([bundle](const std::stop_token& ended) {
        return study::session_length(*bundle, interfaces(), timed_people,
                                     [&ended] { return !ended.stop_requested(); });
      });
    }
  }
  if (auto orders = work_.news()) {
    orders_ = std::move(*orders);
    shown_.clear();
    for (const study::InterfaceUse& one : orders_->bundle->study.interfaces) {
      shown_.push_back(one.name);
    }
  }
  if (auto length = timing_.news()) length_ = *length;
}

void PlanPage::draw(const Ui& ui, const study::Texts& words, const Box& room) {
  const Box inner = inside(ui, room, 16);
  const StudyReading* const reading = study_.reading();
  if (reading != nullptr && !reading->bundle) {
    Column column(ui, inside(ui, inner, 24));
    return column.words(
        ui.look.fonts.reading, ui.look.palette.alarm,
        words("shell.cannot_run") + "\n" + problem_words(reading->problems.front(), words));
  }
  const float wide = ui.layout.size(440);
  const Box panel{inner.right() - wide, inner.y, wide, inner.height};
  const Box left{inner.x, inner.y, panel.x - inner.x - ui.layout.size(16), inner.height};
  fill(panel, ui.look.palette.panel);
  if (orders_) draw_orders(ui, words, left);
  scrolled("plan", panel, high_, [&](const Box& all) {
    Column column(ui, inside(ui, all, 20));
    draw_people(ui, words, column);
    power_.draw(ui, words, column, people_.value);
    high_ = column.left().y - all.y + ui.layout.size(20);
  });
}

void PlanPage::draw_orders(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  const float row = ui.layout.size(36);
  const float first = ui.layout.size(72);
  std::size_t most = 1;
  for (const std::vector<int>& order : orders_->blocks) most = std::max(most, order.size());
  const float cell = (box.width - first) / static_cast<float>(most);
  const Box head{box.x, box.y, box.width, row};
  draw_text(ui.look.fonts.text, {head.x + ui.layout.size(8), head.y, first, row}, palette.quiet,
            words("plan.person"));
  for (std::size_t k = 0; k < most; ++k) {
    draw_text(ui.look.fonts.text,
              {head.x + first + cell * static_cast<float>(k), head.y, cell, row}, palette.quiet,
              words.with("plan.block", {{"number", std::to_string(k + 1)}}));
  }
  const Box rows{box.x, head.bottom(), box.width, box.height - row};
  scrolled("orders", rows, row * static_cast<float>(orders_->blocks.size()), [&](const Box& all) {
    const float shown = all.width - first;
    for (std::size_t i = 0; i < orders_->blocks.size(); ++i) {
      const float y = all.y + row * static_cast<float>(i);
      if (y > rows.bottom() || y + row < rows.y) continue;
      draw_text(ui.look.fonts.text, {all.x + ui.layout.size(8), y, first, row}, palette.quiet,
                std::to_string(i + 1));
      const std::vector<int>& order = orders_->blocks[i];
      for (std::size_t k = 0; k < order.size(); ++k) {
        const float width = shown / static_cast<float>(most);
        const Box chip{all.x + first + width * static_cast<float>(k), y + 2,
                       width - ui.layout.size(4), row - 4};
        const auto colour = static_cast<std::size_t>(order[k]) % palette.clusters.size();
        fill(chip, palette.panel);
        fill({chip.x, chip.y, ui.layout.size(6), chip.height}, palette.clusters[colour]);
        draw_line(
            ui.look.fonts.text,
            {chip.x + ui.layout.size(16), chip.y, chip.width - ui.layout.size(24), chip.height},
            palette.text, name(order[k]));
      }
    }
  });
}

void PlanPage::draw_people(const Ui& ui, const study::Texts& words, Column& column) {
  const Palette& palette = ui.look.palette;
  const Box line = column.take(40, 12);
  draw_text(ui.look.fonts.title, line, palette.text, words("plan.people"));
  const float wide = ui.layout.size(170);
  if (number_box(ui, "people", {line.right() - wide, line.y, wide, line.height}, people_, 1,
                 most_people, now_us_)) {
    begin();
  }
  if (!orders_) {
    return column.words(ui.look.fonts.text, palette.quiet, words("plan.working"));
  }
  const bool even = people_.value % orders_->round == 0;
  column.words(
      ui.look.fonts.text, even ? palette.bookmark : palette.pilot,
      words.with(even ? "plan.even" : "plan.uneven", {{"round", std::to_string(orders_->round)}}),
      8);
  const auto minutes = [](double value) { return fmt::format("{:.0f}", std::ceil(value)); };
  column.words(ui.look.fonts.text, palette.text,
               length_ ? words.with("plan.minutes", {{"median", minutes(length_->median)},
                                                     {"least", minutes(length_->least)},
                                                     {"most", minutes(length_->most)}})
                       : words("plan.timing"),
               16);
  draw_table(ui, words, column, orders_->balance.position, "plan.positions", false);
  draw_table(ui, words, column, orders_->balance.carry_over, "plan.carry_over", true);
}

void PlanPage::draw_table(const Ui& ui, const study::Texts& words, Column& column,
                          const Eigen::MatrixXi& counts, const char* title, bool by_interface) {
  if (counts.rows() < 2) return;
  const Palette& palette = ui.look.palette;
  draw_text(ui.look.fonts.bold, column.take(28, 0), palette.text, words(title));
  const auto columns = static_cast<int>(counts.cols());
  const auto cell = [&](const Box& row, int index) {
    const float first = 0.34f * row.width;
    const float width = (row.width - first) / static_cast<float>(columns);
    return Box{row.x + first + width * static_cast<float>(index), row.y, width - ui.layout.size(4),
               row.height};
  };
  const Box head = column.take(26, 0);
  for (int c = 0; c < columns; ++c) {
    draw_line(ui.look.fonts.text, cell(head, c), palette.quiet,
              by_interface ? name(c) : std::to_string(c + 1), Align::right);
  }
  for (Eigen::Index r = 0; r < counts.rows(); ++r) {
    const Box row = column.take(26, 0);
    draw_line(ui.look.fonts.text, {row.x, row.y, 0.33f * row.width, row.height}, palette.text,
              name(static_cast<int>(r)));
    for (int c = 0; c < columns; ++c) {
      const bool itself = by_interface && r == c;
      draw_text(ui.look.fonts.text, cell(row, c), itself ? palette.quiet : palette.text,
                itself ? "–" : std::to_string(counts(r, c)), Align::right);
    }
  }
  column.skip(16);
}

}  // namespace

std::unique_ptr<DeskPage> make_plan_page(DeskServices& services, OpenStudy& study) {
  return std::make_unique<PlanPage>(services, study);
}

}  // namespace promenade::app
