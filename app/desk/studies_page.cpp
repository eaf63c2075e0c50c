// Studies: the list of them, and what can be done with one.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/choice.h"
#include "app/desk/column.h"
#include "app/desk/pages.h"
#include "app/desk/table.h"
#include "app/text_box.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

using study::ShelvedStudy;
using study::StudyPlace;

constexpr TableColumn columns[] = {
    {"studies.name", 0.02f, 0.48f},
    {"studies.state", 0.48f, 0.66f},
    {"studies.people", 0.66f, 0.8f},
    {"studies.last_run", 0.8f, 1},
};

// "studies/oshita-2018.toml" to "oshita-2018".
std::string key_of_template(const std::string& name) {
  return std::filesystem::path(name).stem().string();
}

class StudiesPage : public DeskPage {
 public:
  explicit StudiesPage(DeskServices& services)
      : services_(services), templates_(study::study_templates()) {}

  void advance(std::int64_t now_us) override;
  void draw(const Ui& ui, const study::Texts& words, const Box& room) override;
  void dropped(const std::vector<std::string>& paths) override;
  const std::vector<std::string>& shown_words() const override { return shown_; }

 private:
  void draw_list(const Ui& ui, const study::Texts& words, const Box& box);
  void draw_row(const Ui& ui, const study::Texts& words, const ShelvedStudy& one, const Box& box);
  void draw_chosen(const Ui& ui, const study::Texts& words, Column& column);
  void draw_new(const Ui& ui, const study::Texts& words, Column& column);
  bool name_box(const Ui& ui, const std::string& hint, const char* target, Draft& draft,
                const Box& box);
  const ShelvedStudy* chosen() const;
  // Does it, and takes the study that comes of it; says why not.
  void attempt(const std::function<StudyPlace()>& work);
  void choose(const std::string& name);

  DeskServices& services_;
  std::vector<std::string> templates_;
  std::size_t template_ = 0;
  std::vector<ShelvedStudy> studies_;
  std::string chosen_;  // by name
  Draft new_name_, other_name_;
  std::string trouble_;
  int number_ = -1;  // of the look that is shown
  std::int64_t now_us_ = 0;
  std::vector<std::string> shown_;
};

void StudiesPage::advance(std::int64_t now_us) {
  now_us_ = now_us;
  if (services_.studies.number() == number_) return;
  number_ = services_.studies.number();
  studies_ = services_.studies.studies();
  shown_ = {trouble_};
  for (const ShelvedStudy& one : studies_) {
    shown_.push_back(one.place.name());
    shown_.push_back(one.problem);
  }
  if (chosen() == nullptr) chosen_ = studies_.empty() ? "" : studies_.front().place.name();
}

const ShelvedStudy* StudiesPage::chosen() const {
  for (const ShelvedStudy& one : studies_) {
    if (one.place.name() == chosen_) return &one;
  }
  return nullptr;
}

void StudiesPage::choose(const std::string& name) {
  chosen_ = name;
  other_name_ = {};
  trouble_.clear();
}

void StudiesPage::attempt(const std::function<StudyPlace()>& work) {
  try {
    choose(work().name());
    new_name_ = {};
  } catch (const InputError& error) {
    const Problem& problem = error.problems().front();
    trouble_ = problem.file + ": " + problem.message;
  } catch (const std::exception& error) {
    trouble_ = error.what();
  }
  services_.studies.look_now();
  advance(now_us_);
}

// A study file from elsewhere is copied, with what it names.
void StudiesPage::dropped(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const std::filesystem::path file(path);
    if (file.extension() != ".toml") continue;
    attempt([&] {
      return services_.shelf.add_file(file, services_.shelf.free_name(file.stem().string()));
    });
  }
}

void StudiesPage::draw(const Ui& ui, const study::Texts& words, const Box& room) {
  const Box inner = inside(ui, room, 16);
  const float wide = ui.layout.size(400);
  const float gap = ui.layout.size(16);
  const Box panel{inner.right() - wide, inner.y, wide, inner.height};
  draw_list(ui, words, {inner.x, inner.y, inner.width - wide - gap, inner.height});
  fill(panel, ui.look.palette.panel);
  Column column(ui, inside(ui, panel, 20));
  draw_chosen(ui, words, column);
  draw_new(ui, words, column);
  if (!trouble_.empty()) column.words(ui.look.fonts.text, ui.look.palette.alarm, trouble_);
}

void StudiesPage::draw_list(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  if (studies_.empty()) {
    Column column(ui, inside(ui, box, 40));
    column.skip(120);
    column.words(ui.look.fonts.title, palette.text, words("studies.none"));
    column.words(ui.look.fonts.reading, palette.quiet, words("studies.none_hint"));
    return;
  }
  draw_table(ui, words, "studies", box, columns, ui.layout.size(48), studies_.size(),
             [&](std::size_t i, const Box& row) { draw_row(ui, words, studies_[i], row); });
}

std::string people_words(const study::Texts& words, const ShelvedStudy& one) {
  if (one.planned == 0) return std::to_string(one.finished);
  return words.with("studies.of", {{"done", std::to_string(one.finished)},
                                   {"planned", std::to_string(one.planned)}});
}

Rgb colour_of(const Palette& palette, study::StudyState state) {
  switch (state) {
    case study::StudyState::piloted:
      return palette.pilot;
    case study::StudyState::running:
      return palette.created;
    case study::StudyState::finished:
      return palette.bookmark;
    case study::StudyState::draft:
      break;
  }
  return palette.quiet;
}

void StudiesPage::draw_row(const Ui& ui, const study::Texts& words, const ShelvedStudy& one,
                           const Box& box) {
  const Palette& palette = ui.look.palette;
  const std::string name = one.place.name();
  const bool marked = name == chosen_;
  fill(box, marked ? palette.known : palette.panel);
  const bool pressed = tile(ui, "study", name, box);
  const auto cell = [&](std::size_t column, ImFont* font, const Rgb& colour,
                        std::string_view text) {
    draw_line(font, cell_of(box, columns[column]), colour, text);
  };
  cell(0, ui.look.fonts.bold, palette.text, name);
  if (!one.problem.empty()) {
    draw_line(ui.look.fonts.text, cell_of(box, {"", columns[1].from, 1}), palette.alarm,
              one.problem);
  } else {
    const std::string state = "studies." + std::string(study::to_text(one.state));
    cell(1, ui.look.fonts.bold, colour_of(palette, one.state), words(state));
    cell(2, ui.look.fonts.text, palette.text, people_words(words, one));
    cell(3, ui.look.fonts.text, palette.quiet,
         one.last_run_utc.empty() ? "–" : one.last_run_utc.substr(0, 10));
  }
  if (!pressed) return;
  if (marked) return services_.open(one.place);
  choose(name);
}

bool StudiesPage::name_box(const Ui& ui, const std::string& hint, const char* target, Draft& draft,
                           const Box& box) {
  text_box(ui, target, box, draft, {.most = 60, .several = false, .hint = hint.c_str()}, now_us_);
  return draft.entered;
}

void StudiesPage::draw_chosen(const Ui& ui, const study::Texts& words, Column& column) {
  const ShelvedStudy* const one = chosen();
  if (one == nullptr) return;
  const Palette& palette = ui.look.palette;
  const StudyPlace place = one->place;
  draw_line(ui.look.fonts.title, column.take(36, 4), palette.text, place.name());
  column.words(ui.look.fonts.text, palette.quiet,
               words("studies." + std::string(study::to_text(one->state)) + "_says"), 4);
  draw_line(ui.look.fonts.text, column.take(24, 8), palette.quiet, place.folder.string());
  if (!one->problem.empty()) column.words(ui.look.fonts.text, palette.alarm, one->problem);
  const Box first = column.take(44);
  if (button(ui, "open", first, words("studies.open"), ButtonKind::filled)) {
    return services_.open(place);
  }
  const bool entered =
      name_box(ui, words("studies.other_hint"), "other_name", other_name_, column.take(40));
  const Box row = column.take(40, 28);
  const std::string name = other_name_.text.words();
  const bool named = !name.empty();
  if (button(ui, "duplicate", part_of_row(ui, row, 0, 2), words("studies.duplicate"),
             ButtonKind::outlined, named)) {
    return attempt([&] { return services_.shelf.duplicate(place, name); });
  }
  if (button(ui, "rename", part_of_row(ui, row, 1, 2), words("studies.rename"),
             ButtonKind::outlined, named) ||
      (entered && named)) {
    if (services_.in_use(place)) {
      trouble_ = words("studies.in_use");
      return;
    }
    attempt([&] {
      StudyPlace renamed = services_.shelf.rename(place, name);
      services_.renamed(place, renamed);
      return renamed;
    });
  }
}

void StudiesPage::draw_new(const Ui& ui, const study::Texts& words, Column& column) {
  const Palette& palette = ui.look.palette;
  draw_text(ui.look.fonts.title, column.take(36, 4), palette.text, words("studies.new"));
  std::vector<std::string> names;
  for (const std::string& one : templates_) {
    names.push_back(words("studies.template." + key_of_template(one) + ".name"));
  }
  if (const auto picked = drop_down(ui, "template", column.take(40), names, template_)) {
    template_ = *picked;
  }
  const std::string key = key_of_template(templates_[template_]);
  column.words(ui.look.fonts.text, palette.quiet, words("studies.template." + key + ".says"), 8);
  const bool entered =
      name_box(ui, words("studies.name_hint"), "new_name", new_name_, column.take(40));
  const std::string name = new_name_.text.words();
  if (button(ui, "make", column.take(44), words("studies.make"), ButtonKind::filled) || entered) {
    attempt([&] {
      const std::string wanted = name.empty() ? services_.shelf.free_name(names[template_]) : name;
      return services_.shelf.add_template(templates_[template_], wanted);
    });
  }
}

}  // namespace

std::unique_ptr<DeskPage> make_studies_page(DeskServices& services) {
  return std::make_unique<StudiesPage>(services);
}

}  // namespace promenade::app
