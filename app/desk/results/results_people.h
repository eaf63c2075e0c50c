// Results, the list of people: who took part, and what is to be done about one of them: left out
// with a reason, or withdrawn because they ask for it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/exclusions.h"
#include "app/desk/column.h"
#include "app/desk/open_study.h"
#include "app/desk/services.h"
#include "app/text_box.h"
#include "study/session_list.h"
#include "study/texts.h"

namespace promenade::app {

class ResultsPeople {
 public:
  ResultsPeople(DeskServices& services, const study::StudyPlace& place)
      : services_(services), place_(place) {}

  // Anew from the database and the file of exclusions.
  void read();
  void draw_list(const Ui& ui, const study::Texts& words, const Box& box);
  // What can be done about the chosen one.
  void draw_chosen(const Ui& ui, const study::Texts& words, Column& column, std::int64_t now_us);
  bool has_simulated() const;
  const std::vector<std::string>& shown_words() const { return shown_; }

 private:
  void draw_row(const Ui& ui, const study::Texts& words, const study::ListedSession& one,
                const Box& box);
  void draw_exclusion(const Ui& ui, const study::Texts& words, Column& column, std::int64_t now_us);
  void draw_withdrawal(const Ui& ui, const study::Texts& words, Column& column,
                       std::int64_t now_us);
  const study::ListedSession* chosen() const;
  const analysis::Exclusion* exclusion_of(const std::string& code) const;
  std::filesystem::path database() const;
  void read_exclusions();
  void change_exclusions(const std::function<void(std::vector<analysis::Exclusion>& all)>& change);
  void withdraw(const study::Texts& words, const std::string& code);

  DeskServices& services_;
  study::StudyPlace place_;
  std::vector<study::ListedSession> sessions_;
  std::vector<analysis::Exclusion> exclusions_;
  std::string chosen_, trouble_;    // chosen: a session's uuid
  std::string exclusions_trouble_;  // why they cannot be read or written; empty: they can
  Draft reason_, code_again_;
  std::vector<std::string> shown_;
};

}  // namespace promenade::app
