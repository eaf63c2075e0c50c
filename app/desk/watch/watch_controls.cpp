#include "app/desk/watch/watch_controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/monitor_words.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

using study::Texts;
using study::WatchedSession;
using study::WatchedState;

constexpr Order pause{.name = "pause", .what = "pause"};
constexpr Order resume{.name = "resume", .what = "resume"};
constexpr Order release{.name = "release", .what = "release", .is_about_page = true};
constexpr Order skip{.name = "skip", .what = "skip", .needs_words = true, .is_about_page = true};
constexpr Order repeat_trial{
    .name = "repeat_trial", .what = "repeat", .needs_words = true, .is_about_page = true};
constexpr Order repeat_block{.name = "repeat_block",
                             .what = "repeat",
                             .block = true,
                             .needs_words = true,
                             .is_about_page = true};
constexpr Order note{.name = "note", .what = "note", .needs_words = true};
constexpr Order stop{.name = "stop", .what = "stop", .needs_words = true};

constexpr const char* words_field = "watch:words";
constexpr std::int64_t opening_us = 15'000'000;  // a window takes so long at most

std::string target_of(const Order& order) { return std::string("watch:") + order.name; }

// As Session::can_skip has it.
bool can_skip(const WatchedSession& session) {
  constexpr std::array<std::string_view, 6> pages = {"trial",         "instructions", "intro",
                                                     "questionnaire", "release",      "break"};
  return std::find(pages.begin(), pages.end(), session.page) != pages.end();
}

bool is_possible(const Order& order, const WatchedSession& session) {
  if (&order == &skip) return can_skip(session);
  if (order.what == repeat_trial.what) return session.trial || session.trials_done > 0;
  return true;
}

std::vector<const Order*> orders_for(const WatchedSession& session) {
  std::vector<const Order*> orders = {session.state == WatchedState::paused ? &resume : &pause};
  if (session.page == "release") orders.push_back(&release);
  orders.insert(orders.end(), {&skip, &repeat_trial, &repeat_block, &note, &stop});
  return orders;
}

std::string label_of(const Texts& texts, const Order& order) {
  return texts(&order == &release ? "watch.release_now" : std::string("watch.") + order.name);
}

std::string question_of(const Texts& texts, const Order& order, const WatchedSession& session) {
  if (&order == &note) return texts("watch.note_what");
  return texts.with(std::string("watch.") + order.name + "_why",
                    {{"doing", doing_words(texts, session)}});
}

// The button of these words, the first at the left of the row; the row begins behind it then.
bool row_button(const Ui& ui, std::string_view target, Box& row, std::string_view label,
                ButtonKind kind, bool enabled = true) {
  const float wide = std::ceil(text_width(ui.look.fonts.bold, label)) + ui.layout.size(24);
  const Box box{row.x, row.y, wide, row.height};
  row.x += wide + ui.layout.size(8);
  row.width -= wide + ui.layout.size(8);
  return button(ui, target, box, label, kind, enabled) && enabled;
}

bool is_running(const WatchedSession& session) {
  return session.state == WatchedState::running || session.state == WatchedState::paused;
}

}  // namespace

WatchControls::WatchControls(std::string database, Resume on_resume)
    : asked_(std::move(database)), on_resume_(std::move(on_resume)) {}

float WatchControls::height(const Ui& ui) { return ui.layout.size(108); }

void WatchControls::follow(const study::Watched& now, std::int64_t now_us) {
  asked_.follow(now, now_us);
}

void WatchControls::draw(const Ui& ui, const Texts& texts, const WatchedSession* session,
                         const Box& box, std::int64_t now_us) {
  now_us_ = now_us;
  const Palette& palette = ui.look.palette;
  fill(box, palette.panel);
  fill({box.x, box.y, box.width, ui.layout.size(1)}, palette.line);
  const float inset = ui.layout.size(16);
  const Box inner{box.x + inset, box.y + ui.layout.size(8), box.width - 2 * inset,
                  box.height - ui.layout.size(16)};
  const float asked = std::round(0.32f * inner.width);
  const Box left{inner.x, inner.y, inner.width - asked - inset, inner.height};
  draw_asked(ui, texts, {inner.right() - asked, inner.y, asked, inner.height});
  const bool writes =
      session != nullptr && writing_ && writing_->session == session->uuid && is_running(*session);
  if (writing_ && !writes) writing_.reset();
  if (session == nullptr) {
    return draw_text(ui.look.fonts.reading, left, palette.quiet, texts("watch.pick"));
  }
  if (writes) return draw_writing(ui, texts, *session, left);
  const Box title{left.x, left.y, left.width, ui.layout.size(32)};
  draw_line(ui.look.fonts.reading, title, palette.text,
            texts.with("watch.whom",
                       {{"doing", doing_words(texts, *session)}, {"code", session->participant}}));
  const Box row{left.x, title.bottom() + ui.layout.size(8), left.width, ui.layout.size(44)};
  if (is_running(*session)) return draw_buttons(ui, texts, *session, row);
  draw_resume(ui, texts, *session, row);
}

void WatchControls::draw_buttons(const Ui& ui, const Texts& texts, const WatchedSession& session,
                                 const Box& row) {
  Box left = row;
  for (const Order* order : orders_for(session)) {
    const bool first = order == &pause || order == &resume || order == &release;
    const ButtonKind kind = first ? ButtonKind::filled : ButtonKind::outlined;
    if (row_button(ui, target_of(*order), left, label_of(texts, *order), kind,
                   is_possible(*order, session))) {
      press(ui, *order, session);
    }
  }
}

void WatchControls::draw_resume(const Ui& ui, const Texts& texts, const WatchedSession& session,
                                const Box& row) {
  if (!on_resume_ || session.state == WatchedState::ended) return;
  const bool opening = resumed_ == session.uuid && now_us_ - resumed_us_ < opening_us;
  Box left = row;
  if (row_button(ui, "watch:start", left, texts("watch.start"), ButtonKind::filled, !opening)) {
    resumed_ = session.uuid;
    resumed_us_ = now_us_;
    on_resume_(session);
  }
  if (opening) draw_line(ui.look.fonts.text, left, ui.look.palette.quiet, texts("watch.starting"));
}

void WatchControls::press(const Ui& ui, const Order& order, const WatchedSession& session) {
  trouble_.clear();
  ui.focus.settle();
  if (!order.needs_words) return ask(order, session, "");
  writing_.emplace();
  writing_->order = &order;
  writing_->session = session.uuid;
}

// What it is about is told as it is now: what is sent is about that.
void WatchControls::draw_writing(const Ui& ui, const Texts& texts, const WatchedSession& session,
                                 const Box& box) {
  const Box title{box.x, box.y, box.width, ui.layout.size(32)};
  const std::string question = question_of(texts, *writing_->order, session);
  const bool is_note = writing_->order == &note;
  const std::string advice = texts(!writing_->missing ? "watch.keys"
                                   : is_note          ? "watch.note_missing"
                                                      : "watch.words_missing");
  const float wide = text_width(ui.look.fonts.text, advice);
  draw_line(ui.look.fonts.reading,
            {title.x, title.y, title.width - wide - ui.layout.size(16), title.height},
            ui.look.palette.text, question);
  draw_text(ui.look.fonts.text, title,
            writing_->missing ? ui.look.palette.alarm : ui.look.palette.quiet, advice,
            Align::right);
  draw_line_to_write(ui, texts, session,
                     {box.x, title.bottom() + ui.layout.size(8), box.width, ui.layout.size(44)});
}

void WatchControls::draw_line_to_write(const Ui& ui, const Texts& texts,
                                       const WatchedSession& session, const Box& row) {
  const auto width_of = [&](const char* key) {
    return std::ceil(text_width(ui.look.fonts.bold, texts(key))) + ui.layout.size(32);
  };
  const float buttons = width_of("watch.send") + width_of("watch.give_up");
  const Box field{row.x, row.y, row.width - buttons - ui.layout.size(8), row.height};
  Draft& draft = writing_->draft;
  const bool wrote = draft.active;
  if (std::exchange(writing_->begins, false)) ui.focus.write_in("type", words_field);
  const TextBoxOptions options{.most = study::most_request_characters, .several = false};
  text_box(ui, words_field, field, draft, options, now_us_);
  if (draft.changed) writing_->missing = false;
  Box right{field.right() + ui.layout.size(8), row.y, buttons, row.height};
  const bool pressed = row_button(ui, "watch:send", right, texts("watch.send"), ButtonKind::filled);
  const bool given_up =
      row_button(ui, "watch:give_up", right, texts("watch.give_up"), ButtonKind::outlined);
  if (given_up || key_pressed(ImGuiKey_Escape, false)) {
    ui.focus.use_escape();
    return put_away(ui);
  }
  if (pressed || (wrote && key_pressed(ImGuiKey_Enter, false))) send(ui, session);
}

void WatchControls::send(const Ui& ui, const WatchedSession& session) {
  const std::string words = writing_->draft.text.words();
  writing_->missing = words.find_first_not_of(" \n") == std::string::npos;
  writing_->begins = writing_->missing;
  ui.focus.settle();
  if (writing_->missing) return;
  ask(*writing_->order, session, words);
  if (trouble_.empty()) put_away(ui);
}

// The keyboard is where it was before.
void WatchControls::put_away(const Ui& ui) {
  ui.focus.go_on("press", target_of(*writing_->order));
  writing_.reset();
}

void WatchControls::ask(const Order& order, const WatchedSession& session,
                        const std::string& words) {
  try {
    trouble_.clear();
    asked_.ask(order, session, words, now_us_);
  } catch (const OutsideError& error) {
    trouble_ = error.what();
  }
}

// The latest first, as many as there is room for.
void WatchControls::draw_asked(const Ui& ui, const Texts& texts, const Box& box) const {
  const Palette& palette = ui.look.palette;
  ImFont* font = ui.look.fonts.text;
  float y = box.y;
  const auto say = [&](const std::string& words, const Rgb& colour) {
    const float high = paragraphs_height(font, box.width, words);
    if (y + high > box.bottom()) return false;
    draw_paragraphs(font, box.x, y, box.width, colour, words);
    y += high + ui.layout.size(4);
    return true;
  };
  if (!trouble_.empty()) say(trouble_, palette.alarm);
  const std::vector<Asked>& all = asked_.all();
  for (std::size_t i = all.size(); i > 0; --i) {
    const Asked::State state = all[i - 1].state;
    const bool bad = state == Asked::State::refused || state == Asked::State::silent;
    const Rgb& colour = bad ? palette.alarm : i == all.size() ? palette.text : palette.quiet;
    if (!say(asked_words(texts, all[i - 1]), colour)) return;
  }
}

}  // namespace promenade::app
