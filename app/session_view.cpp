#include "app/session_view.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "app/trial_cast.h"
#include "study/adjective_model.h"
#include "study/identity.h"

namespace promenade::app {
namespace {

using study::PageKind;

constexpr const char* closed_by_hand = "window closed";
constexpr int most_passes = 32;  // in one frame
constexpr std::int64_t ask_period_us = 200'000;

std::vector<OfferedLanguage> offered(const study::StudyBundle& bundle) {
  std::vector<OfferedLanguage> languages;
  for (const std::string& code : bundle.study.languages) {
    const study::Texts texts = study::texts_of(bundle, code);
    languages.push_back({code, texts("language"), texts("welcome.language")});
  }
  return languages;
}

void add_local(const study::LocalText& text, std::vector<std::string>& words) {
  for (const auto& [language, content] : text) words.push_back(content);
}

void add_words(const study::Instrument& instrument, std::vector<std::string>& words) {
  add_local(instrument.title, words);
  add_local(instrument.text, words);
  for (const study::Item& item : instrument.items) {
    for (const study::LocalText* text : {&item.question, &item.low, &item.high}) {
      add_local(*text, words);
    }
    for (const study::Choice& choice : item.choices) add_local(choice.text, words);
  }
}

}  // namespace

std::vector<std::string> shown_words(const study::StudyBundle& bundle) {
  std::vector<std::string> words;
  if (bundle.adjectives) {
    const std::vector<std::string>& pairs = bundle.adjectives->table.pairs;
    words.insert(words.end(), pairs.begin(), pairs.end());
    for (const study::PrimaryWords& one : bundle.adjectives->words) {
      for (const study::LocalText* text : {&one.name, &one.low, &one.high}) add_local(*text, words);
    }
  }
  const study::Study& study = bundle.study;
  for (const std::string& language : study.languages) {
    for (std::string& word : words_of(captions_in(language, bundle))) {
      words.push_back(std::move(word));
    }
  }
  add_local(study.title, words);
  add_local(study.consent, words);
  for (const study::Instrument& instrument : study.instruments) add_words(instrument, words);
  for (const study::Task& task : study.tasks) {
    for (const study::Target& target : task.targets) add_local(target.quality, words);
    for (const study::Target& target : task.practice) add_local(target.quality, words);
  }
  return words;
}

SessionView::SessionView(const study::StudyBundle& bundle, const study::InterfaceRegistry& registry,
                         const Gui& gui, LiveSession& live, InputQueue& queue,
                         const ViewOptions& options)
    : bundle_(bundle),
      registry_(registry),
      gui_(gui),
      live_(live),
      queue_(queue),
      options_(options),
      language_(options.language.empty() ? bundle.study.languages.front() : options.language),
      captions_(captions_in(language_, bundle)),
      languages_(offered(bundle)),
      stage_(bundle.space.set, bundle.bank, bundle.study.display.travels, bundle.study.stimuli),
      content_{bundle.space, captions_, &stage_.small_figures()},
      average_(motion::blend(bundle.space, study::start_weights(bundle.space))) {
  assert(options.participant.size() < memory_.code.size() && "the code has been checked");
  std::copy(options.participant.begin(), options.participant.end(), memory_.code.begin());
  // Whoever left is asked for the code; with it, the session is offered.
  for (const study::InterruptedSession& one : options.interrupted) {
    if (!one.left || !options.participant.empty()) memory_.offered.push_back(one);
  }
}

void SessionView::speak(const std::string& language) {
  language_ = language;
  captions_ = captions_in(language, bundle_);
}

bool SessionView::covered() const {
  return live_.session().paused() || live_.failure().has_value();
}

bool SessionView::has_panel() const {
  const PageKind kind = live_.session().page().kind;
  return kind == PageKind::trial || kind == PageKind::instructions;
}

Cast SessionView::cast(std::int64_t now_us) const {
  const study::Session& session = live_.session();
  if (const study::TrialState* trial = session.trial()) {
    return trial_cast(bundle_, session, trial->cycle, live_.since_began(now_us));
  }
  if (session.page().kind != PageKind::instructions) return {};
  const study::Task& task = task_of(bundle_.study, planned());
  const bool rated = task.kind == study::TaskKind::rate;
  const bool target = task.kind != study::TaskKind::find;
  const bool created = !task.blind && !rated;
  const bool beside = rated && task.reference >= 0;  // the words speak of it
  return {.target = target ? &average_ : nullptr,
          .created = created ? &average_ : nullptr,
          .reference = beside ? &bundle_.space.set.cycles[static_cast<std::size_t>(task.reference)]
                              : nullptr};
}

const study::PlannedTrial& SessionView::planned() const {
  const study::Session& session = live_.session();
  return session.plan().trials[static_cast<std::size_t>(session.page().trial)];
}

void SessionView::advance(std::int64_t now_us) {
  if (covered()) return stage_.rest(now_us);
  stage_.advance(now_us, cast(now_us));
}

void SessionView::draw_figures(FigureRenderer& renderer) {
  if (covered()) return;
  const Layout& layout = gui_.layout();
  const Palette& palette = gui_.look().palette;
  stage_.draw(renderer, layout, stage_plan(), palette);
  if (has_panel()) renderer.fill(layout.panel(), palette.panel);
  stage_.draw_small(renderer, palette);
}

StagePlan SessionView::stage_plan() const {
  const bool trial = live_.session().page().kind == PageKind::trial;
  if (!trial) return gui_.layout().instructions_plan();
  return gui_.layout().stage_plan(bundle_.study.display.examples == study::ExamplesWall::panel);
}

Moment SessionView::moment_at(std::int64_t t_us, std::int64_t uncertainty_us) const {
  // An event may have come while the frame before was still on screen.
  const std::int64_t frame = t_us >= shown_us_ ? shown_us_ : shown_before_us_;
  return {t_us, uncertainty_us, frame, queue_.x(), queue_.y()};
}

void SessionView::take_presses() {
  for (const UiPress& press : queue_.presses()) {
    Moment moment = moment_at(press.t_us, press.uncertainty_us);
    moment.x = press.x;
    moment.y = press.y;
    live_.take(study::Press{}, moment);
  }
}

int SessionView::cover() const {
  return (live_.session().paused() ? 1 : 0) + (memory_.panel.open ? 2 : 0);
}

bool SessionView::has_turned() const {
  return page_ != &live_.session().page() || cover_ != cover();
}

// Another page, or one that covers it; what was written belongs to its own page.
bool SessionView::is_fresh() {
  const study::Session& session = live_.session();
  const bool turned = page_ != &session.page();
  const bool covered = cover_ != cover();
  page_ = &session.page();
  cover_ = cover();
  if (turned) {
    memory_.drafts.clear();
    memory_.orders.clear();
    memory_.next_open.clear();
  }
  return turned || covered;
}

void SessionView::frame(std::int64_t now_us) {
  const bool seen = !has_turned();
  pass(now_us);
  for (int k = 1; seen && k < most_passes && !queue_.empty() && !has_turned() && !ended(); ++k) {
    pass(now_us);
  }
  take_late_frames(queue_.settled_us(now_us));
  take_requests(now_us);
  live_.tick(queue_.settled_us(now_us));
  live_.flush(now_us);
}

// Behind all that the participant did before.
void SessionView::take_requests(std::int64_t now_us) {
  const bool can = options_.requests != nullptr && live_.recorded() && queue_.empty() && !ended();
  if (!can || now_us - asked_us_ < ask_period_us) return;
  asked_us_ = now_us;
  if (!options_.requests->waiting()) return;
  const study::RequestReader::News news =
      options_.requests->take(live_.store().session(), study::utc_now());
  const Moment moment{.t_us = now_us, .frame_us = shown_us_};
  for (const study::Request& late : news.late) live_.refuse(late, "late", moment);
  for (const study::Request& one : news.asked) obey(one, moment);
  if (news.broken) live_.take(study::Refused{"", "broken"}, moment, study::Actor::system);
}

// Whoever has opened the experimenter's panel decides, a note apart.
void SessionView::obey(const study::Request& request, const Moment& moment) {
  if (memory_.panel.open && request.what != "note") return live_.refuse(request, "panel", moment);
  live_.obey(request, moment);
  if (!live_.session().paused()) memory_.asks_to_end = memory_.back_again = false;
}

void SessionView::settle(std::int64_t now_us) {
  while (!queue_.empty() && !ended()) pass(now_us);
  take_late_frames(now_us);
}

void SessionView::pass(std::int64_t now_us) {
  take_late_frames(queue_.settled_us(now_us));
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = std::max(1e-4f, 1e-6f * static_cast<float>(now_us - drawn_us_));
  drawn_us_ = now_us;
  queue_.feed(io);
  take_presses();
  actions_.clear();
  changes_.clear();
  orders_.clear();
  const bool fresh = is_fresh();
  if (fresh) {
    widgets_.clear();
    focus_.leave();
  }
  ImGui::NewFrame();
  focus_.begin(widgets_);
  stage_.small_figures().clear();
  draw_screen({.ui = {gui_.look(), gui_.layout(), widgets_, focus_},
               .bundle = bundle_,
               .session = live_.session(),
               .texts = captions_.texts,
               .registry = registry_,
               .content = content_,
               .language = language_,
               .participant = live_.participant(),
               .languages = languages_,
               .now_us = live_.since_began(now_us),
               .pilot = options_.pilot,
               .simulated = options_.simulated,
               .fresh = fresh,
               .chord = queue_.chord(),
               .failure = live_.failure() ? live_.failure()->c_str() : nullptr,
               .copy_problem = copy_problem_.empty() ? nullptr : copy_problem_.c_str(),
               .stage = stage_,
               .stage_plan = stage_plan(),
               .memory = memory_,
               .actions = actions_,
               .orders = orders_,
               .changes = changes_});
  ImGui::Render();
  take_actions();
}

void SessionView::take_actions() {
  const Moment moment = moment_at(queue_.t_us(), queue_.uncertainty_us());
  for (study::ControlInput& change : changes_) {
    live_.take(study::Control{std::move(change)}, moment);
  }
  if (!memory_.resume.empty()) return resume(std::exchange(memory_.resume, ""), drawn_us_);
  if (memory_.refuses_offers) refuse_offers();
  if (memory_.wants_start) leave_welcome();
  if (live_.failure()) {
    closed_ = closed_ || !actions_.empty();
    return;
  }
  if (memory_.wants_close) return close_left();
  if (memory_.wants_end) return end(closed_by_hand, moment.t_us, study::Actor::participant);
  for (StudyAction& action : actions_) live_.take(std::move(action), moment);
  for (StudyAction& order : orders_) {
    live_.take(std::move(order), moment, study::Actor::experimenter);
  }
  const std::string& chosen = live_.session().language();
  if (!chosen.empty() && chosen != language_) speak(chosen);
}

// Is the code on the welcome page in the roster? Then it is as the roster has it, with its order.
bool SessionView::is_expected() {
  if (!options_.ask_roster || live_.recorded()) return true;
  try {
    const RosterAnswer answer = options_.ask_roster(memory_.code.data());
    memory_.code_unknown = answer.kind == RosterAnswer::Kind::unknown;
    memory_.code_taken = answer.kind == RosterAnswer::Kind::taken;
    if (answer.kind != RosterAnswer::Kind::welcome) return false;
    assert(answer.row.code.size() < memory_.code.size() && "codes of a roster are short");
    memory_.code.fill('\0');
    std::copy(answer.row.code.begin(), answer.row.code.end(), memory_.code.begin());
    live_.change_sequence(answer.row.sequence);
    return true;
  } catch (const std::exception& error) {
    live_.fail(error.what());
    return false;
  }
}

void SessionView::leave_welcome() {
  memory_.wants_start = false;
  if (!is_expected()) return;
  const std::string code = memory_.code.data();
  for (const study::InterruptedSession& one : options_.interrupted) {
    if (one.participant == code && !live_.recorded()) {
      memory_.offered = {one};
      return;
    }
  }
  memory_.code_known = !live_.record_as(code, !memory_.same_person);
  memory_.same_person = false;
  if (memory_.code_known || live_.failure()) return;
  actions_.emplace_back(study::Continue{});
}

// What was not taken up is not offered again.
void SessionView::refuse_offers() {
  for (const study::InterruptedSession& one : memory_.offered) {
    std::erase_if(options_.interrupted, [&](auto& other) { return other.uuid == one.uuid; });
  }
  memory_.offered.clear();
  memory_.refuses_offers = false;
}

void SessionView::resume(const std::string& uuid, std::int64_t now_us) {
  const LiveSession::Resumed resumed = live_.resume(uuid, bundle_, registry_, now_us);
  memory_.resume_differs = resumed == LiveSession::Resumed::differs;
  if (resumed != LiveSession::Resumed::yes) {
    std::erase_if(memory_.offered, [&](auto& one) { return one.uuid == uuid; });
    std::erase_if(options_.interrupted, [&](auto& one) { return one.uuid == uuid; });
    return;
  }
  memory_.offered.clear();
  memory_.back_again = live_.session().paused();
  speak(live_.language());
}

void SessionView::shown(const ShownFrame& frame) {
  shown_before_us_ = shown_us_;
  shown_us_ = frame.shown_us;
  live_.count(frame);
  if (frame.late_us > 0 && live_.session().trial() != nullptr) late_.push_back(frame);
  take_late_frames(queue_.settled_us(shown_us_));
  live_.flush(shown_us_);
}

// In the order of the times: what is logged later than it came gets a later time.
void SessionView::take_late_frames(std::int64_t until_us) {
  while (!late_.empty() && late_.front().shown_us <= until_us) {
    const ShownFrame frame = late_.front();
    late_.erase(late_.begin());
    if (live_.session().trial() == nullptr) continue;
    live_.take(study::LateFrame{frame.late_us},
               {.t_us = frame.shown_us, .frame_us = frame.shown_us}, study::Actor::system);
  }
}

// Nothing ends: the session waits for its return.
void SessionView::close_left() {
  live_.save();
  closed_ = true;
}

void SessionView::stop(const std::string& reason, std::int64_t now_us, study::Actor actor) {
  settle(now_us);
  if (live_.session().left()) return close_left();
  end(reason, now_us, actor);
}

void SessionView::end(const std::string& reason, std::int64_t t_us, study::Actor actor) {
  if (!ended()) live_.take(study::Stop{reason}, {.t_us = t_us, .frame_us = shown_us_}, actor);
  closed_ = true;
}

void SessionView::ask_to_close(std::int64_t now_us) {
  settle(now_us);
  if (ended()) return;
  if (live_.session().left()) return close_left();
  const bool again = memory_.asks_to_end && live_.session().paused();
  const bool can_pause = app::can_pause(live_.session().page().kind) && !live_.failure();
  if (again || !can_pause) return stop(closed_by_hand, now_us, study::Actor::participant);
  memory_.asks_to_end = true;
  if (live_.session().paused()) return;
  live_.take(study::Pause{}, {.t_us = now_us, .frame_us = shown_us_});
}

bool SessionView::ended() const { return closed_ || live_.session().ended(); }

}  // namespace promenade::app
