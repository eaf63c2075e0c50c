#include "study/session.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

#include "study/session_steps.h"

namespace promenade::study {

std::string_view to_text(Actor actor) {
  switch (actor) {
    case Actor::participant:
      return "participant";
    case Actor::system:
      return "system";
    case Actor::experimenter:
      return "experimenter";
  }
  return "";
}

std::string_view to_text(Outcome outcome) {
  switch (outcome) {
    case Outcome::running:
      return "running";
    case Outcome::finished:
      return "finished";
    case Outcome::declined:
      return "declined";
    case Outcome::withdrawn:
      return "withdrawn";
    case Outcome::stopped:
      return "stopped";
  }
  return "";
}

std::string_view to_text(TrialOutcome outcome) {
  switch (outcome) {
    case TrialOutcome::success:
      return "success";
    case TrialOutcome::timeout:
      return "timeout";
    case TrialOutcome::done:
      return "done";
    case TrialOutcome::skipped:
      return "skipped";
    case TrialOutcome::aborted:
      return "aborted";
  }
  return "";
}

Session::Session(const StudyBundle& bundle, const InterfaceRegistry& registry, Plan plan,
                 bool asks_language)
    : bundle_(&bundle),
      registry_(&registry),
      plan_(std::move(plan)),
      asks_language_(asks_language),
      attempts_(plan_.trials.size(), 0) {
  assert(!plan_.pages.empty() && plan_.pages[0].kind != PageKind::trial &&
         "a session begins with a page that waits");
}

Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

void Session::change_sequence(int sequence) {
  assert(page_ == 0 && !declined_ && "the participant has seen nothing of the plan");
  plan_ = make_plan(bundle_->study, sequence);
  attempts_.assign(plan_.trials.size(), 0);
}

const Page& Session::page() const {
  static const Page declined{PageKind::declined, -1};
  static const Page language{PageKind::language, -1};
  if (asks_language_) return language;
  return declined_ ? declined : plan_.pages[page_];
}

int Session::page_index() const {
  return asks_language_ || declined_ ? -1 : static_cast<int>(page_);
}

const TrialState* Session::trial() const { return trial_ ? &*trial_ : nullptr; }

std::int64_t Session::trial_us(std::int64_t t_us) const {
  assert(trial_ && "a trial runs");
  return trial_->control_us(paused_since_us_ ? std::min(t_us, *paused_since_us_) : t_us);
}

bool Session::can_continue() const {
  const PageKind kind = page().kind;
  const bool waits_for_more =
      kind == PageKind::trial || kind == PageKind::language || kind == PageKind::release;
  return !ended() && !waits_for_more && break_left_us() == 0 && answered();
}

const Instrument* Session::questions() const {
  const Study& study = bundle_->study;
  const Page& now = page();
  int index = -1;
  if (now.kind == PageKind::questionnaire) {
    index = study.questionnaires[static_cast<std::size_t>(now.questionnaire)].instrument;
  } else if (trial_) {
    index = task_of(study, plan_.trials[static_cast<std::size_t>(trial_->index)]).instrument;
  }
  return index < 0 ? nullptr : &study.instruments[static_cast<std::size_t>(index)];
}

std::int64_t Session::break_left_us() const {
  if (page().kind != PageKind::break_) return 0;
  return std::max<std::int64_t>(0, opened_us_ + bundle_->study.breaks.least_us - now_us_);
}

std::vector<Record> Session::step(const Input& input) {
  if (ended()) return {};
  now_us_ = input.t_us;
  Steps steps{*this, input};
  steps.begin();
  // Nothing here may end the pause: its time is not over.
  if (steps.rests()) {
    std::visit([&](const auto& action) { steps.act(action); }, input.action);
    return std::move(steps.records);
  }
  if (steps.stands()) return std::move(steps.records);
  steps.wake();
  steps.pass_deadlines(input.t_us);
  std::visit([&](const auto& action) { steps.act(action); }, input.action);
  steps.pass_deadlines(input.t_us);  // a dwell time of 0 has passed at once
  return std::move(steps.records);
}

std::string Session::Steps::json_text(const char* key, const std::string& text) const {
  nlohmann::json json{{key, text}};
  if (!input.request.empty()) json["request"] = input.request;
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Event& Session::Steps::log(const char* kind) {
  Event event;
  event.trial = session.trial_ ? session.trial_->index : -1;
  event.t_us = input.t_us;
  event.uncertainty_us = input.uncertainty_us;
  event.frame_us = input.frame_us;
  event.actor = input.actor;
  event.kind = kind;
  if (!input.request.empty()) event.detail = R"({"request":")" + input.request + R"("})";
  const bool by_participant =
      input.actor == Actor::participant && !std::holds_alternative<LateFrame>(input.action);
  if (session.trial_ && by_participant) {
    session.trial_->process.input(session.trial_->control_us(input.t_us));
  }
  return std::get<Event>(records.emplace_back(std::move(event)));
}

Event& Session::Steps::log_system(const char* kind, std::int64_t t_us) {
  Event event;
  event.trial = session.trial_ ? session.trial_->index : -1;
  event.t_us = t_us;
  event.kind = kind;
  return std::get<Event>(records.emplace_back(std::move(event)));
}

void Session::Steps::begin() {
  if (session.begun_) return;
  session.begun_ = true;
  open_page(0);
}

void Session::Steps::open_page(std::int64_t t_us) {
  const Page& page = session.page();
  Event& event = log_system("page", t_us);
  event.target = to_text(page.kind);
  const bool planned = page.kind != PageKind::declined && page.kind != PageKind::language;
  if (planned) event.value = static_cast<double>(session.page_);
  session.opened_us_ = t_us;
  decide(t_us);
  if (page.kind == PageKind::trial) {
    open_trial(t_us);
  } else {
    open_questions();
  }
}

void Session::Steps::decide(std::int64_t t_us) {
  const PageKind page = session.page().kind;
  Outcome outcome = Outcome::running;
  if (page == PageKind::thanks) outcome = Outcome::finished;
  if (page == PageKind::declined) outcome = Outcome::declined;
  if (outcome == session.decided_) return;
  session.decided_ = outcome;
  records.emplace_back(SessionDecided{t_us, outcome});
}

void Session::Steps::next_page(std::int64_t t_us) {
  if (session.page().kind != PageKind::trial) session.just_ended_.reset();
  if (session.declined_) return end(t_us, Outcome::declined);
  if (repeat_practice(t_us)) return;
  if (session.page_ + 1 >= session.plan_.pages.size()) return end(t_us, Outcome::finished);
  session.page_ = page_behind(session.page_);
  pass_won_trials(t_us);
  open_page(t_us);
}

void Session::Steps::end(std::int64_t t_us, Outcome outcome) {
  session.outcome_ = outcome;
  records.emplace_back(SessionEnded{t_us, outcome});
}

void Session::Steps::act(const ChooseLanguage& choice) {
  const std::vector<std::string>& offered = session.bundle_->study.languages;
  const bool known = std::find(offered.begin(), offered.end(), choice.language) != offered.end();
  if (!session.asks_language_ || !known) return;
  log("language").target = choice.language;
  session.language_ = choice.language;
  session.asks_language_ = false;
  open_page(input.t_us);
}

void Session::Steps::act(const Continue&) {
  if (!session.can_continue()) {
    log("continue_refused");
    return;
  }
  log("continue");
  emit_answers();
  next_page(input.t_us);
}

void Session::Steps::act(const Decline&) {
  if (session.page().kind != PageKind::consent) return;
  log("decline");
  session.declined_ = true;
  open_page(input.t_us);
}

void Session::Steps::act(const Stop& stop) {
  log("stop").detail = json_text("reason", stop.reason);
  emit_answers();
  if (session.trial_) end_trial(input.t_us, TrialOutcome::aborted);
  // Whoever closes the last page has finished.
  const bool open = session.decided_ == Outcome::running;
  end(input.t_us, open ? Outcome::stopped : session.decided_);
}

}  // namespace promenade::study
