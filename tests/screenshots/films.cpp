#include "tests/screenshots/films.h"

#include <set>

#include "app/registry.h"

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

void answer_all(Studio& studio, const study::StudyBundle& bundle) {
  for (const study::Rating& rating : bundle.study.ratings) {
    studio.take(study::SetAnswer{rating.item, 4});
  }
}

void leave_page(Studio& studio, const study::StudyBundle& bundle) {
  switch (studio.session().page().kind) {
    case PageKind::welcome:
      return studio.begin_as("P07");
    case PageKind::trial:
      return studio.take(study::Done{});
    case PageKind::rating:
      answer_all(studio, bundle);
      return studio.take(study::Continue{});
    default:
      return studio.take(study::Continue{});
  }
}

ViewOptions options_of(const Film& film, const std::string& language) {
  ViewOptions options;
  options.language = language;
  options.pilot = film.pilot;
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
    leave_page(studio, film.bundle);
  }
}

// A trial that counts, in the middle of it.
void shoot_trial(const Film& film, Studio& studio, const Reel& reel) {
  if (!reel.wants(film.only)) return;
  while (studio.session().trial() == nullptr || studio.planned().practice) {
    leave_page(studio, film.bundle);
  }
  studio.play(inputs);
  studio.pass(1);
  reel.album.add(reel.prefix, film.only, studio.shoot());
}

Film one_trial(const std::string& name, const Scene& scene) {
  return {.bundle = make_study(scene), .only = name};
}

// The interfaces of the pictures that show something else; whichever there are.
std::vector<std::string> usual() {
  for (const char* name : {"map", "labels"}) {
    if (interfaces().find(name) != nullptr) return {name};
  }
  return {interfaces().all().front().name};
}

}  // namespace

std::vector<Film> all_films() {
  std::vector<Film> films;
  films.push_back({.bundle = make_study({})});
  films.push_back({.bundle = make_study({.set = "builtin:N"}), .interfaces_only = true});
  films.push_back(one_trial("blind", {.match = "blind = true", .interfaces = usual()}));
  films.push_back(one_trial("playback", {.match = "playback = true", .interfaces = usual()}));
  films.push_back(one_trial("pilot", {.interfaces = usual()}));
  films.back().pilot = true;
  for (const char* set : {"builtin:A", "builtin:N"}) {
    const Scene walls{.set = set,
                      .display = "examples = \"panel\"",
                      .match = "playback = true",
                      .interfaces = usual()};
    films.push_back(one_trial("wall", walls));
  }
  for (const study::InterfaceUse& use : films.front().bundle.study.interfaces) {
    films.push_back(one_trial("paper-" + use.name,
                              {.display = "colours = \"paper\"", .interfaces = {use.name}}));
    const Scene longer{.interfaces = {use.name}, .long_names = true};
    if (can_have(longer, use.name)) films.push_back(one_trial("long-" + use.name, longer));
  }
  return films;
}

void shoot_film(const Film& film, Room& room, const std::string& language, const Reel& reel) {
  Studio studio(room, film.bundle, options_of(film, language));
  film.only.empty() ? shoot_pages(film, studio, reel) : shoot_trial(film, studio, reel);
}

}  // namespace promenade::app::screenshots
