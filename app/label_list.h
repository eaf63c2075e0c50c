// The list of labels ([N] 6): its state during a trial, and its lines as they stand in the
// panel. No clock; app/interfaces/labels.cpp draws it.
#pragma once

#include "app/list_groups.h"
#include "app/panel.h"
#include "app/shelf.h"
#include "app/shelf_view.h"
#include "study/utf8.h"

namespace promenade::app {

constexpr int longest_filter = 30;  // characters

// Inputs: pick happy; filter list, TEXT and show_all list (aside); and those of the shelf.
class Labels final : public study::InterfaceState {
 public:
  explicit Labels(const study::InterfaceContext& context)
      : start_(context.start),
        shelf_(context.space.set, nullptr, context.start),
        sorted_(std::get<bool>(context.parameters.at("sorted"))),
        groups_(style_groups(context.space.set)),
        grouping_(grouping_of(std::get<std::string>(context.parameters.at("groups")), groups_)) {}

  std::unique_ptr<InterfaceState> clone() const override { return std::make_unique<Labels>(*this); }

  study::Applied apply(const study::ControlInput& input) override {
    if (input.kind == "pick") {
      const int cycle = motion::find_cycle(shelf_.set(), input.target);
      if (cycle < 0) return study::Applied::refused;
      shelf_.go({.example = cycle});
      return study::Applied::done;
    }
    if (input.kind == "filter" || input.kind == "show_all") return search(input);
    return shelf_.apply(input, {study::weights_of(*this, input.t_us)});
  }

  void weights(std::int64_t, Eigen::VectorXd& weights) const override {
    if (!shelf_.weights(weights)) weights = start_;
  }

  std::vector<study::ControlInput> settings() const override {
    std::vector<study::ControlInput> settings;
    shelf_.add_settings(settings);
    if (picked() >= 0) {
      settings.push_back(
          {.kind = "pick", .target = std::string(shelf_.target_of({.example = picked()}))});
    }
    return settings;
  }

  const Shelf& shelf() const { return shelf_; }
  int picked() const { return shelf_.current().example; }  // -1: none
  bool sorted() const { return sorted_; }
  Grouping grouping() const { return grouping_; }
  int group(int cycle) const { return groups_[static_cast<std::size_t>(cycle)]; }
  void restored(const InterfaceState& left, const Eigen::VectorXd&, std::int64_t) override {
    filter_ = static_cast<const Labels&>(left).filter_;
  }

  const std::string& filter() const { return filter_; }

 private:
  study::Applied search(const study::ControlInput& input) {
    const bool fits = study::first_characters(input.text, longest_filter) == input.text;
    if (input.target != "list" || !fits) return study::Applied::refused;
    filter_ = input.kind == "filter" ? input.text : "";
    return study::Applied::aside;
  }

  Eigen::VectorXd start_;
  Shelf shelf_;
  bool sorted_;
  std::vector<int> groups_;
  Grouping grouping_;
  std::string filter_;
};

// The list as it stands: its lines from the top, with headings, without what does not match.
class Lines {
 public:
  Lines(const Labels& labels, const study::InterfacePanel& panel)
      : labels_(labels), panel_(panel), size_(labels.shelf().set().size()) {}

  // heading(text) and row(cycle, label), in their order.
  template <typename Heading, typename Row>
  void visit(const Heading& heading, const Row& row) const {
    for (int k = 0; k < size_; ++k) {
      if (!leads(k)) continue;
      const int first = cycle(k);
      const std::size_t shared = shared_by_group(k);
      heading(heading_of(first, shared, k));
      for (int m = k; m < size_; ++m) {
        if (!shows(cycle(m)) || !together(first, cycle(m))) continue;
        row(cycle(m), after_heading(name(cycle(m)), shared));
      }
    }
  }

 private:
  int cycle(int place) const {
    return labels_.sorted() ? panel_.content().captions.by_name[static_cast<std::size_t>(place)]
                            : place;
  }
  std::string_view name(int cycle) const {
    return panel_.content().captions.names[static_cast<std::size_t>(cycle)];
  }
  bool shows(int cycle) const { return matches(name(cycle), labels_.filter()); }
  bool together(int a, int b) const {
    if (labels_.grouping() == Grouping::style) return labels_.group(a) == labels_.group(b);
    return labels_.grouping() == Grouping::none || letter_of(name(a)) == letter_of(name(b));
  }
  // Is it the first of its group?
  bool leads(int place) const {
    if (!shows(cycle(place))) return false;
    for (int k = 0; k < place; ++k) {
      if (shows(cycle(k)) && together(cycle(k), cycle(place))) return false;
    }
    return true;
  }
  // Bytes of the name that all of the group begin with, also those that do not match.
  std::size_t shared_by_group(int place) const {
    if (labels_.grouping() != Grouping::style) return 0;
    const std::string_view first = name(cycle(place));
    std::size_t shared = first.size();
    for (int k = 0; k < size_; ++k) {
      if (!together(cycle(k), cycle(place))) continue;
      shared = shared_beginning(first, shared, name(cycle(k)));
    }
    return shared;
  }
  ShortLine heading_of(int cycle, std::size_t shared, int place) const {
    if (labels_.grouping() == Grouping::style) {
      return ShortLine().add(name(cycle).substr(0, shared > 0 ? shared : std::string::npos));
    }
    if (labels_.grouping() == Grouping::alphabet) return letter_heading(letter_of(name(cycle)));
    int count = 0;
    for (int k = place; k < size_; ++k) count += shows(this->cycle(k)) ? 1 : 0;
    return with_number(panel_.text("interface.labels.count"), count);
  }
  ShortLine letter_heading(std::string_view letter) const {
    if (letter == "hiragana") return ShortLine().add(panel_.text("interface.labels.hiragana"));
    if (letter == "katakana") return ShortLine().add(panel_.text("interface.labels.katakana"));
    if (letter == "kanji") return ShortLine().add(panel_.text("interface.labels.kanji"));
    return ShortLine().add(letter);
  }

  const Labels& labels_;
  const study::InterfacePanel& panel_;
  int size_;
};

}  // namespace promenade::app
