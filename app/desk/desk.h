// The desk: the experimenter's window, where a study is made, checked, rehearsed, run and watched.
// At the top are the places where one can be, in the middle the page of one of them, at the foot
// what runs beside. Needs no window itself, so that tests drive it.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/desk/open_study.h"
#include "app/desk/page.h"
#include "app/desk/services.h"
#include "app/tool_page.h"
#include "study/watch.h"

namespace promenade::app {

struct DeskSetting {
  std::string studies;                // the folder of them
  std::string language = "en";        // of desk_languages()
  std::string program;                // that runs commands; empty: this one
  std::vector<std::string> displays;  // their names, for the participant's window
  // Shows a file with whatever the system has for it.
  std::function<void(const std::string& path)> show;
};

class Desk {
 public:
  // The queue outlives it.
  Desk(DeskSetting setting, InputQueue& queue);
  ~Desk();

  void advance(std::int64_t now_us);
  void draw_figures(FigureRenderer& renderer, const Gui& gui);
  void frame(Gui& gui);
  void dropped(const std::vector<std::string>& paths);

  void go(DeskPlace place);
  void open(const study::StudyPlace& study);
  DeskPlace place() const { return place_; }
  // That is open here; null: at the places without one.
  const OpenStudy* study() { return room().study.get(); }
  // The window is to be closed. False: a page has changes that are not saved, and is open now;
  // asked again within some seconds, they are given up, and the next such page is asked about.
  bool may_close();
  // Figures walk, or something waits to be shown.
  bool moves() const;
  // A person is taking part at this machine, or frames are measured: leave it the machine.
  bool quiet() const { return jobs_.quiet() || studies_.session_lives(); }
  // What may be shown now beside the texts of the desk, for the characters of the fonts.
  std::vector<std::string> shown_words() const;
  const WidgetMap& widgets() const { return page_.widgets(); }
  const Focus& focus() const { return page_.focus(); }
  DeskJobs& jobs() { return jobs_; }

 private:
  // A study stays open, with its pages, until the desk is closed: nothing on them is lost.
  struct Room {
    std::unique_ptr<OpenStudy> study;  // null: the places without a study
    std::array<std::unique_ptr<DeskPage>, desk_places> pages;
  };

  Room& room();
  DeskPage& page();
  std::unique_ptr<DeskPage> make_page(DeskPlace place);
  void resume(const study::StudyPlace& study, const study::WatchedSession& session);
  void draw(const Ui& ui);
  void draw_tabs(const Ui& ui, const Box& bar);
  void draw_tab(const Ui& ui, DeskPlace place, Box& left);
  // A line that says so where a study runs as it is on the disk; returns its height.
  float draw_unsaved(const Ui& ui, const Box& box);
  DeskPage* edit_page();  // of this study; null: it was not opened
  void show(const std::string& path);
  bool in_use(const study::StudyPlace& study) const;
  void follow(const study::StudyPlace& from, const study::StudyPlace& to);
  void hear_keys();
  void change_language();

  DeskSetting setting_;
  study::StudyShelf shelf_;
  ShelfWatch studies_;
  DeskJobs jobs_;
  DeskServices services_;
  std::string language_;
  std::map<std::string, study::Texts, std::less<>> words_;  // by language
  DeskPlace place_ = DeskPlace::studies;
  std::optional<study::StudyPlace> study_;
  std::map<std::string, Room> rooms_;  // by the study's folder; "": those without a study
  std::map<const DeskPage*, std::int64_t> asked_;  // pages that were asked about, and when
  std::int64_t now_us_ = 0;
  ToolPage page_;
};

}  // namespace promenade::app
