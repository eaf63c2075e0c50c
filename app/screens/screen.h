// The pages of a session. Each is a function that runs every frame: it reads the
// session, draws, and appends what the participant did. Start here to understand
// app/screens; one file holds one kind of page.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/live_session.h"
#include "app/panel.h"
#include "app/participant_code.h"
#include "app/stage.h"
#include "app/text_box.h"
#include "study/session.h"

namespace promenade::app {

// The page over all others that only the experimenter opens.
struct ExperimenterPanel {
  bool open = false;
  bool over_pause = false;  // the session stood already
  Draft words;              // a note, or the reason for what is done
  std::string said;         // key of the text that answers the last button
};

// What the screen remembers between frames, beside the session.
struct ScreenMemory {
  // Being typed; the longest code has room at four bytes a character.
  std::array<char, 4 * longest_participant_code + 1> code{};
  bool code_known = false;    // somebody has taken part with it: is it the same person?
  bool code_unknown = false;  // it is not in the roster
  bool code_taken = false;    // it is, and nobody can begin with it any more
  bool same_person = false;   // that was answered with yes
  // Sessions that were interrupted here; empty: none, or a new one is to begin.
  std::vector<study::InterruptedSession> offered;
  std::string resume;           // uuid of the one that is to go on
  bool refuses_offers = false;  // none of them is
  bool resume_differs = false;  // one could not: another version of the program wrote it
  bool wants_start = false;     // the welcome page is left: the code is to be checked
  bool too_early = false;       // the main button was pressed while it could not be
  bool refused = false;         // in this frame
  bool asks_to_end = false;     // the window was to be closed: the pause offers the end
  bool wants_end = false;       // and that was pressed
  bool back_again = false;      // the session goes on after an interruption
  std::optional<Orbit> told;    // the camera that was last reported
  std::pair<int, int> camera_attempt = {-1, 0};  // the trial and attempt the camera was set for
  Eigen::VectorXd example;                       // scratch of the wall
  // The controls in the picture of the instructions, and the trial that they are for.
  std::unique_ptr<study::InterfaceState> pictured;
  int pictured_trial = -1;
  std::vector<study::ControlInput> unheard;  // what a picture reports
  // Of the questions on this page, by item: what is being written, and the order of a ranking
  // so far, by names.
  std::map<std::string, Draft> drafts;
  std::map<std::string, std::vector<std::string>> orders;
  std::string next_open;     // the question that was the first one without an answer
  bool wants_close = false;  // the page that says how to come back was read
  std::string writes_next;   // the field that the keyboard goes to once it is there
  ExperimenterPanel panel;
};

// A language that the study is offered in, as its own file says it.
struct OfferedLanguage {
  std::string code, name, ask;
};

// What a page draws from.
struct Screen {
  Ui ui;
  const study::StudyBundle& bundle;
  const study::Session& session;
  const study::Texts& texts;
  const study::InterfaceRegistry& registry;
  const study::InterfacePanel::Content& content;
  std::string_view language;
  std::string_view participant;  // the code; empty: not yet
  const std::vector<OfferedLanguage>& languages;
  std::int64_t now_us;  // since the session began
  bool pilot, simulated;
  bool fresh;                // the first frame of this page
  bool chord;                // the keys of the experimenter's panel were pressed
  const char* failure;       // why the session has to stop; null: it goes on
  const char* copy_problem;  // why there is no second copy of the database; null: none
  Stage& stage;
  const StagePlan& stage_plan;
  ScreenMemory& memory;
  std::vector<StudyAction>& actions;          // out: of the participant
  std::vector<StudyAction>& orders;           // out: of the experimenter
  std::vector<study::ControlInput>& changes;  // out: what was done to the controls
};

// Everything on screen but the figures, between ImGui::NewFrame and Render.
void draw_screen(const Screen& screen);

// Where somebody may want to rest: not before the first page has been left, and not after
// the last.
bool can_pause(study::PageKind kind);

void draw_resume(const Screen& screen);
void draw_language(const Screen& screen);
void draw_welcome(const Screen& screen);
void draw_consent(const Screen& screen);
void draw_instructions(const Screen& screen);
void draw_intro(const Screen& screen);
void draw_trial(const Screen& screen);
void draw_questionnaire(const Screen& screen);
void draw_break(const Screen& screen);
void draw_release(const Screen& screen);
void draw_pause(const Screen& screen);    // over any page
void draw_closing(const Screen& screen);  // thanks, and the page after no consent
void draw_left(const Screen& screen);     // how to come back another day
void draw_failure(const Screen& screen);
// The experimenter's panel: is it open, now that its keys may have been pressed?
bool open_experimenter(const Screen& screen);
void draw_experimenter(const Screen& screen);

// Parts that several pages share.
struct PageTexts {
  std::string_view title, text, button;
  std::string_view target = "continue";  // of the button
  bool by_enter = true;                  // Enter presses it while the keyboard is nowhere
  std::string_view missing = {};         // what stands beside it once it was pressed too early
  Box missing_at = {};                   // where; empty: in the column
};
// The heading and the text alone.
float draw_text_column(const Screen& screen, std::string_view title, std::string_view text);
// A column with a heading, text and the page's main button; returns where free room
// begins, pixels. A text that is too long scrolls. True in `pressed`: the button was.
float draw_text_page(const Screen& screen, const PageTexts& texts, bool enabled, bool& pressed);
// A page's main button; true: pressed, or Enter was.
bool main_button(const Screen& screen, const PageTexts& texts, const Box& box, bool enabled);
// What is drawn until end_body() scrolls, by wheel and keys, when its `height` is more than
// that of the box. Returns where it begins, pixels; `bottom` is where it ended.
float begin_body(const Screen& screen, const Box& box, float height);
void end_body(const Screen& screen, const Box& box, float bottom);
// How the trial before ended, if it did so by itself, in one calm line.
void draw_just_ended(const Screen& screen, const Box& line);
// In a practice trial: what to try next.
void draw_practice_hint(const Screen& screen, const study::TrialState& trial);
// The plates, and what the mouse does on the stage: the left button turns the figures,
// another moves them, the wheel brings them closer.
void draw_stage(const Screen& screen);
// Play, pause, slow motion and scrub.
void draw_transport(const Screen& screen);
// All examples, walking.
void draw_wall(const Screen& screen);
// The same anywhere. `scratch`: N weights.
void draw_examples(const Ui& ui, const Box& box, const study::InterfacePanel::Content& content,
                   SmallFigures& figures, Eigen::VectorXd& scratch);
// The questions of a rate task in the panel, with Done below; and a picture of them.
void draw_rate(const Screen& screen);
void draw_rate_picture(const Screen& screen);
const study::PlannedTrial& planned_trial(const Screen& screen);
// Not in rate tasks.
const study::InterfaceUse& use_of(const Screen& screen);
// What participants call it.
std::string title_of(const Screen& screen, const study::InterfaceUse& use);
// The place of this trial among those that count: of the session, or of its task.
struct Place {
  int number = 0, count = 0;
};
Place place_of(const Screen& screen, bool within_task);
// "Task 3 of 20"
std::string number_of(const Screen& screen);
const study::Task& task_of(const Screen& screen);
// "Find a walk that looks confident", with the prefix of the key ("trial", "intro").
std::string ask(const Screen& screen, const std::string& prefix);

}  // namespace promenade::app
