// Sliders of parameters whose values at the examples are known ([O] 3-5): the state of
// the interfaces `adjectives` and `features`. A person chooses which parameters have a
// slider; the weights come from radial basis functions ([O] Eq. 7) that are fitted again
// whenever that changes. Start here, then app/interfaces/adjectives.cpp; drawn by
// app/parameter_sliders_view.h.
//
// Inputs, all refused where they cannot be:
//   slide   PARAMETER, value 0 to 1
//   add     PARAMETER: a slider for it, where the shown motion stands
//   alter   PARAMETER, text = the one whose slider it takes
//   delete  PARAMETER: its slider goes; without any the start is shown
//   weight  CYCLE, value 0 to 1: a blend weight itself; the others keep the proportions that
//           they had before the first of a row of inputs for it, and the sliders follow. The next
//           `slide` returns to the parameters.
//   list    "add" or a PARAMETER to alter: opens the list;  back "list": closes it
//   show, hide  "weights": the column of blend weights
#pragma once

#include <memory>
#include <vector>

#include "app/slider_catalogue.h"

namespace promenade::app {

inline constexpr int most_sliders = 12;
inline constexpr std::int64_t ease_us = 400'000;

class ParameterSliders final : public study::InterfaceState {
 public:
  struct Slider {
    int parameter;
    double value;  // 0 to 1
  };
  enum class List { closed, adding, altering };

  // `context.model` is a SliderCatalogue.
  explicit ParameterSliders(const study::InterfaceContext& context);

  // What undo comes back to: the sliders, not the list that lay over them.
  std::unique_ptr<study::InterfaceState> clone() const override;
  study::Applied apply(const study::ControlInput& input) override;
  void weights(std::int64_t t_us, Eigen::VectorXd& weights) const override;
  std::vector<study::ControlInput> settings() const override;
  void restored(const InterfaceState& left, const Eigen::VectorXd& shown,
                std::int64_t t_us) override;

  double weight_at(std::int64_t t_us, int cycle) const;
  const SliderCatalogue& catalogue() const { return *catalogue_; }
  const motion::MotionSet& set() const { return *set_; }
  const std::vector<Slider>& sliders() const { return sliders_; }
  int find_slider(int parameter) const;  // -1: it has none
  double start_of(int parameter) const;  // where the start stands, 0 to 1
  bool full() const;                     // no slider can be added
  List list() const { return list_; }
  int altered() const { return altered_; }  // the parameter that gives its slider away
  bool weights_visible() const { return weights_visible_; }

 private:
  using Input = study::ControlInput;
  enum class Source { start, sliders, hand };  // of the weights that are shown

  study::Applied slide(const Input& input);
  study::Applied add(const Input& input);
  study::Applied alter(const Input& input);
  study::Applied remove(const Input& input);
  study::Applied weight(const Input& input);
  study::Applied open_list(const Input& input);
  study::Applied close_list(const Input& input);
  study::Applied show_weights(const Input& input);
  study::Applied hide_weights(const Input& input);

  int slider_of(const Input& input) const;         // index; -1: none of that name
  int unused_parameter(const Input& input) const;  // -1: none, or it has a slider
  double eased(std::int64_t t_us) const;           // 0 to 1: how far from from_ to target_
  double value_now(int parameter) const;           // of what is shown, once it has settled
  void ease_from(std::int64_t t_us);
  void sliders_changed(std::int64_t t_us);
  void aim();
  void follow();

  std::shared_ptr<const SliderCatalogue> catalogue_;
  const motion::MotionSet* set_;
  std::vector<Slider> sliders_;
  std::shared_ptr<const motion::RadialBasis> basis_;  // of these sliders
  Source source_ = Source::start;
  Eigen::VectorXd start_, from_, target_;  // N: eases from one to the other
  Eigen::VectorXd proportions_;            // N: when the weight that is held was taken
  int held_ = -1;                          // the cycle whose weight was dragged last; -1: none
  std::int64_t began_us_ = 0;
  List list_ = List::closed;
  int altered_ = -1;
  bool weights_visible_;
};

// A few slides; without sliders, what leads to one.
std::vector<study::ControlInput> simulate_sliders(const study::InterfaceState& state,
                                                  study::Rng& rng);

}  // namespace promenade::app
