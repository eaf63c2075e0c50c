#include "tests/screenshots/films.h"

#include <GLFW/glfw3.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <set>

#include "app/registry.h"
#include "study/embedded.h"
#include "study/simulated.h"

namespace promenade::app::screenshots {
namespace {

using study::PageKind;

constexpr int inputs = 6;  // done to the controls of each trial

std::string name_of(const Studio& studio, const study::StudyBundle& bundle) {
  const study::Page& page = studio.session().page();
  std::string name(study::to_text(page.kind));
  if (page.trial < 0) return name;
  const study::PlannedTrial& planned = studio.planned();
  const study::TaskKind task = study::task_of(bundle.study, planned).kind;
  if (planned.interface < 0) return name + "-rate";
  if (page.kind != PageKind::trial && page.kind != PageKind::instructions) {
    return name + (task == study::TaskKind::match ? "" : "-find");
  }
  if (page.kind == PageKind::trial && planned.practice) name = "practice";
  if (task == study::TaskKind::find) name = "find";
  return name + "-" + bundle.study.interfaces[static_cast<std::size_t>(planned.interface)].name;
}

bool with_interface(const Studio& studio) {
  const PageKind kind = studio.session().page().kind;
  return kind == PageKind::trial || kind == PageKind::instructions;
}

// As a person would, `share` of them.
void answer(Studio& studio, double share) {
  study::SimulatedParticipant person(studio.bundle(), interfaces(), 1);
  const auto count = static_cast<double>(studio.session().item_order().size());
  person.next(studio.session());  // a first look
  for (int k = 0; k < std::ceil(share * count); ++k) {
    study::Intention next = person.next(studio.session());
    if (!std::holds_alternative<study::SetAnswer>(next.action)) return;
    studio.take(std::move(next.action));
  }
}

// Practice runs out of time where it can, so that the next page says so.
void leave_trial(Studio& studio) {
  const study::Task& task = study::task_of(studio.bundle().study, studio.planned());
  if (studio.session().questions() != nullptr) answer(studio, 1);
  if (studio.planned().practice && task.limit_s) return studio.pass(46);
  studio.take(study::Done{});
}

void leave_page(Studio& studio) {
  switch (studio.session().page().kind) {
    case PageKind::welcome:
      return studio.begin_as("P07");
    case PageKind::trial:
      return leave_trial(studio);
    case PageKind::questionnaire:
      answer(studio, 1);
      return studio.take(study::Continue{});
    case PageKind::release:
      return studio.take(study::Release{});
    case PageKind::break_:
      studio.pass(21);
      return studio.take(study::Continue{});
    default:
      return studio.take(study::Continue{});
  }
}

}  // namespace

void to_trial(Studio& studio) {
  while (studio.session().trial() == nullptr || studio.planned().practice) leave_page(studio);
  studio.play(inputs);
  studio.pass(1);
}

namespace {

ViewOptions options_of(const Film& film, const std::string& language) {
  ViewOptions options;
  options.language = film.asks_language ? "" : language;
  options.pilot = film.pilot;
  if (film.left) {
    options.interrupted = {{"a", "P07", "", "", 2, 0, true}};
    options.participant = "P07";
  } else if (film.interrupted) {
    options.interrupted = {{"a", "P07", "", "", 2}, {"b", "P12", "", "", 0}};
  }
  return options;
}

void shoot_pages(const Film& film, Studio& studio, const Reel& reel) {
  std::set<std::string> seen;
  while (!studio.view().ended()) {
    const std::string name = name_of(studio, film.bundle);
    const bool wanted = reel.wants(name) && seen.count(name) == 0 &&
                        (with_interface(studio) || !film.interfaces_only);
    if (wanted) {
      seen.insert(name);
      studio.play(inputs);
      studio.pass(1);
      reel.album.add(reel.prefix, name, studio.shoot());
    }
    leave_page(studio);
  }
}

void to_page(Studio& studio, PageKind kind) {
  while (studio.session().page().kind != kind) leave_page(studio);
}

void to_pause(Studio& studio) {
  to_trial(studio);
  studio.press_key(GLFW_KEY_ESCAPE);
}

void to_declined(Studio& studio) {
  to_page(studio, PageKind::consent);
  studio.take(study::Decline{});
}

void to_matched(Studio& studio) {
  while (studio.session().trial() == nullptr || studio.planned().practice) leave_page(studio);
  const study::Target& target = study::target_of(studio.bundle().study, studio.planned());
  studio.take(study::Control{{.kind = "pick", .target = target.name}});
  studio.pass(2);
}

// The disk is full: no file may grow any more.
void to_error(Studio& studio) {
  to_trial(studio);
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full{1, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  studio.play(3);
  setrlimit(RLIMIT_FSIZE, &before);
}

Film one_picture(const std::string& name, const Scene& scene,
                 std::function<void(Studio&)> play = to_trial) {
  return {.bundle = make_study(scene), .name = name, .play = std::move(play)};
}

// The interfaces of the pictures that show something else; whichever there are.
std::vector<std::string> usual() {
  for (const char* name : {"map", "labels"}) {
    if (interfaces().find(name) != nullptr) return {name};
  }
  return {interfaces().all().front().name};
}

void add_pages(std::vector<Film>& films) {
  films.push_back(one_picture("language", {.interfaces = usual()}, [](Studio&) {}));
  films.back().asks_language = true;
  films.push_back(one_picture("declined", {.interfaces = usual()}, to_declined));
  films.push_back(one_picture("pause", {.interfaces = usual()}, to_pause));
  films.push_back(one_picture("error", {.interfaces = usual()}, to_error));
  films.push_back(one_picture(
      "matched", {.match = "threshold = \"auto\"", .interfaces = {"labels"}}, to_matched));
}

Film of_pages(const std::string& name, std::function<void(Studio&)> play) {
  return {.bundle = make_study_of_pages(), .name = name, .play = std::move(play)};
}

void to_instrument(Studio& studio, const std::string& name) {
  const auto is_there = [&] {
    const study::Instrument* asked = studio.session().questions();
    return studio.session().page().kind == PageKind::questionnaire && asked->name == name;
  };
  while (!is_there()) {
    if (studio.session().can_skip()) {
      studio.take(study::Skip{"no picture"});
    } else {
      leave_page(studio);
    }
  }
}

void to_panel(Studio& studio) {
  to_trial(studio);
  studio.press_chord();
  studio.pass(0.1);
  for (const char letter : std::string("The fire alarm rang in the middle of this trial.")) {
    studio.press_letter(letter);
  }
}

// To the introduction of the trial in which the controls are others.
void to_other_controls(Studio& studio) {
  to_page(studio, PageKind::release);
  while (studio.session().page().kind != PageKind::intro || studio.planned().practice ||
         studio.planned().interface == 0) {
    leave_page(studio);
  }
}

void to_trial_of_guess(Studio& studio) {
  while (studio.session().trial() == nullptr || studio.planned().interface < 0) leave_page(studio);
  studio.play(inputs);
}

// The same code a second time.
void to_known_code(Studio& studio) {
  studio.occupy("P07");
  for (int k = 0; k < 3; ++k) studio.pass(0.02);  // the field takes the keyboard
  for (const char letter : std::string("P07")) studio.press_letter(letter);
  studio.press_key(GLFW_KEY_ENTER);
}

void to_rate(Studio& studio) {
  to_page(studio, PageKind::trial);
  answer(studio, 0.5);
}

bool rates_pairs(const Studio& studio) {
  return studio.session().trial() != nullptr && studio.session().item_order().size() > 40;
}

// The 41 pairs, at the second motion.
void to_rate_pairs(Studio& studio) {
  while (!rates_pairs(studio)) leave_page(studio);
  leave_page(studio);
  while (!rates_pairs(studio)) leave_page(studio);
}

void to_rate_pairs_half(Studio& studio) {
  to_rate_pairs(studio);
  answer(studio, 0.5);
  studio.pass(0.5);
}

void to_left(Studio& studio) {
  to_page(studio, PageKind::instructions);
  studio.take(study::Leave{});
  studio.pass(0.2);
}

void to_intro_of_rate(Studio& studio) {
  to_rate_pairs(studio);
  leave_page(studio);
}

void to_missing(Studio& studio) {
  to_instrument(studio, "nasa-tlx");
  answer(studio, 0.4);
  studio.press_key(GLFW_KEY_ENTER);
}

void to_no_copy(Studio& studio) {
  studio.view().tell_copy_problem(
      "/mnt/backup/pages.db cannot be written: no space left on device");
  to_page(studio, PageKind::thanks);
}

// Every instrument, half answered; then the pages around them.
void add_questions(std::vector<Film>& films) {
  for (const std::string& name : study::embedded_names("instruments")) {
    films.push_back(of_pages("items-" + name, [name](Studio& studio) {
      to_instrument(studio, name);
      answer(studio, 0.5);
    }));
  }
  films.push_back(of_pages("items-missing", to_missing));
  films.push_back(of_pages("rate", to_rate));
  films.push_back(of_pages("rate-pairs-begin", to_rate_pairs));
  films.push_back(of_pages("rate-pairs", to_rate_pairs_half));
  films.push_back(of_pages("intro-rate-back", to_intro_of_rate));
  films.push_back(of_pages("left", to_left));
  films.push_back(of_pages("resume-left", [](Studio&) {}));
  films.back().interrupted = films.back().left = true;
  films.push_back(of_pages("instructions-rate",
                           [](Studio& studio) { to_page(studio, PageKind::instructions); }));
  films.push_back(of_pages("guess", to_trial_of_guess));
  films.push_back(of_pages("release", [](Studio& studio) { to_page(studio, PageKind::release); }));
  films.push_back(of_pages("intro-controls", to_other_controls));
  films.push_back(of_pages("experimenter", to_panel));
  films.push_back(of_pages("thanks-no-copy", to_no_copy));
  films.push_back(of_pages("resume", [](Studio&) {}));
  films.back().interrupted = true;
  films.push_back(of_pages("welcome-again", to_known_code));
  films.back().simulated = false;
}

void add_variants(std::vector<Film>& films) {
  films.push_back(one_picture("blind", {.match = "blind = true", .interfaces = usual()}));
  films.push_back(one_picture("instructions-blind",
                              {.match = "blind = true", .interfaces = usual()},
                              [](Studio& studio) { to_page(studio, PageKind::instructions); }));
  films.push_back(
      one_picture("reference", {.match = "reference = \"normal\"", .interfaces = usual()}));
  films.push_back(one_picture("playback", {.match = "playback = true", .interfaces = usual()}));
  films.push_back(one_picture("pilot", {.interfaces = usual()}));
  films.back().pilot = true;
  films.push_back(one_picture("small", {.display = "scale = 0.7", .interfaces = usual()}));
  for (const char* set : {"builtin:A", "builtin:N"}) {
    films.push_back(one_picture("wall", {.set = set,
                                         .display = "examples = \"panel\"",
                                         .match = "playback = true",
                                         .interfaces = usual()}));
  }
}

}  // namespace

std::vector<Film> all_films() {
  std::vector<Film> films;
  films.push_back({.bundle = make_study({.breaks = "after = \"block\"\nleast_s = 20"})});
  films.push_back({.bundle = make_study({.set = "builtin:N"}), .interfaces_only = true});
  const std::vector<study::InterfaceUse> uses = films.front().bundle.study.interfaces;
  add_pages(films);
  add_questions(films);
  add_variants(films);
  for (const study::InterfaceUse& use : uses) {
    films.push_back(one_picture("paper-" + use.name,
                                {.display = "colours = \"paper\"", .interfaces = {use.name}}));
    const Scene longer{.interfaces = {use.name}, .long_names = true};
    if (can_have(longer, use.name)) films.push_back(one_picture("long-" + use.name, longer));
  }
  return films;
}

void shoot_film(const Film& film, Room& room, const std::string& language, const Reel& reel) {
  if (!film.name.empty() && !reel.wants(film.name)) return;
  Studio studio(room, film.bundle, options_of(film, language), film.simulated);
  if (film.name.empty()) return shoot_pages(film, studio, reel);
  film.play(studio);
  reel.album.add(reel.prefix, film.name, studio.shoot());
}

}  // namespace promenade::app::screenshots
