#include "motion/gait/families.h"

#include <algorithm>
#include <initializer_list>

#include "motion/gait/poses.h"
#include "motion/gait/traits.h"

namespace promenade::motion::gait {
namespace {

struct Portion {
  void (*trait)(GaitStyle&, double);
  double amount;
};

// One walk of a family. Valence and arousal are said, the rest of its character comes
// with the traits.
struct Member {
  const char* name;
  double valence, arousal;
  std::initializer_list<Portion> traits;
  void (*own)(GaitStyle&) = nullptr;
};

void crouching(GaitStyle& style) {
  crouched(style, 1.25);
  arms_forward(style, 0.5);
  bent_elbows(style, 0.6);
  still_arms(style, 0.4);
  fast(style, -0.7);
}

void upright(GaitStyle& style) { style.timing.speed = 1.25; }

void wide(GaitStyle& style) {
  wide_stance(style, 1.2);
  elbows_out(style, 1.3);
  bent_elbows(style, 1.2);
  chest_out(style, 0.4);
  still_arms(style, 0.3);
  fast(style, -0.4);
  style.character.weight += 0.3;
}

// A walk is a line or two, not one brace a line.
// clang-format off
constexpr Member crouching_members[] = {
    {"sneaking", -0.1, 0.2, {{high_steps, 1.2}, {bent_elbows, 0.6}, {on_toes, 0.35},
     {elbows_out, 0.4}}},
    {"prowling", -0.3, 0.5, {{crouched, 0.35}, {wide_stance, 0.4}, {arms_out, 0.8},
     {long_steps, 1}, {swaying, 0.6}}},
    {"stalking", -0.4, 0.6, {{crouched, 0.3}, {long_steps, 1}, {arms_forward, 1}, {fast, 0.6},
     {head_down, -0.4}}},
    {"creeping", -0.2, 0.1, {{crouched, 0.4}, {long_steps, -1}, {fast, -0.9}, {bent_elbows, 0.6},
     {head_down, 0.3}}},
    {"skulking", -0.5, -0.2, {{stooped, 0.5}, {shoulders_up, 1}, {head_down, 0.6},
     {wide_stance, -0.5}}},
    {"hobbling", -0.4, -0.5, {{stooped, 0.9}, {dragging, 0.7}, {fast, -0.8}}, with_a_stick},
    {"exhausted", -0.6, -0.9, {{stooped, 0.6}, {head_down, 0.9}, {dragging, 0.9}, {swaying, 1},
     {bent_elbows, -0.4}, {fast, -0.5}}},
    {"burdened", -0.5, 0.1, {{stooped, 1}, {wide_stance, 0.35}, {bent_elbows, 1.1},
     {elbows_out, 0.4}, {still_arms, 0.8}, {head_down, -0.3}}},
    {"against-the-wind", -0.4, 0.6, {{leaning_forward, 1.5}, {head_down, 0.6}, {bent_elbows, 0.5},
     {long_steps, -0.4}, {shoulders_up, 0.6}, {arms_forward, -0.5}}},
    {"cowering", -0.8, 0.4, {{crouched, 0.2}, {shoulders_up, 1.4}, {bent_elbows, 1.2},
     {head_down, 0.9}, {wide_stance, -0.5}, {long_steps, -1}, {fast, -0.5}}},
    {"ducking", -0.4, 0.8, {{crouched, 0.4}, {leaning_forward, 1.1}, {fast, 1.2},
     {bent_elbows, 0.5}, {swinging, 0.6}}},
    {"searching", 0, 0, {{leaning_forward, 0.6}, {head_down, 1.1}, {bent_elbows, -0.3},
     {arms_out, 0.5}}, looking_around},
    {"freezing", -0.7, 0.3, {{shoulders_up, 1.5}, {bent_elbows, 0.9}, {still_arms, 0.9},
     {long_steps, -0.8}, {wide_stance, -0.4}, {fast, 0.6}}, with_crossed_arms},
    {"hunchbacked", -0.4, -0.2, {{stooped, 1.4}, {swaying, 0.7}, {head_down, -0.7},
     {bent_elbows, -0.3}}, limp},
    {"witch", -0.6, 0.2, {{stooped, 1}, {head_down, -0.5}, {arms_forward, 0.6},
     {bent_elbows, 0.8}, {arms_out, 0.7}, {fast, 0.5}}},
    {"miner", -0.2, 0, {{crouched, 0.5}, {leaning_forward, 0.8}, {head_down, -0.8},
     {bent_elbows, -0.5}, {elbows_out, 0.4}}},
    {"on-ice", -0.3, 0.4, {{arms_out, 1.4}, {toes_out, 0.7}, {dragging, 0.8}, {long_steps, -1.2},
     {fast, -0.7}, {arms_forward, 0.4}}},
    {"old", -0.2, -0.5, {{stooped, 0.8}, {dragging, 0.6}, {long_steps, -1}, {toes_out, 0.9},
     {still_arms, 0.5}, {bent_elbows, -0.1}, {fast, -0.5}}},
};

constexpr Member upright_members[] = {
    {"normal", 0, 0, {}},
    {"proud", 0.6, 0.3, {{chest_out, 1.3}, {arms_out, 0.6}, {long_steps, 0.4}}},
    {"marching", 0.1, 0.5, {{stiff, 0.9}, {swinging, 1.2}, {high_steps, 0.5}, {chest_out, 0.7},
     {bent_elbows, -0.3}}},
    {"catwalk", 0.4, 0.3, {{rolling_hips, 1.3}, {wide_stance, -0.8}, {chest_out, 0.5},
     {long_steps, 0.3}, {bent_elbows, -0.2}, {arms_out, 0.3}}},
    {"brisk", 0.3, 0.6, {{fast, 0.9}, {swinging, 0.3}, {leaning_forward, 0.3}}},
    {"tiptoeing", 0.2, 0.1, {{on_toes, 1}, {high_steps, 0.4}, {arms_out, 0.9}, {still_arms, 0.5},
     {long_steps, -0.6}, {fast, -0.5}}},
    {"strolling", 0.5, -0.4, {{fast, -0.9}, {toes_out, 0.9}, {leaning_forward, -0.8},
     {rolling_hips, 0.5}, {arms_out, 0.3}}},
    {"dreaming", 0.6, -0.6, {{fast, -0.7}, {head_down, -0.8}, {swaying, 0.8}}, lost_in_thought},
    {"elegant", 0.5, 0, {{wide_stance, -0.4}, {chest_out, 0.6}, {arms_out, 0.8},
     {still_arms, 0.4}, {on_toes, 0.4}}},
    {"bouncing", 0.8, 0.6, {{bouncing, 1.4}, {swinging, 1}, {arms_out, 0.4}, {head_down, -0.4}}},
    {"swaggering", 0.4, 0.4, {{swaying, 1.2}, {toes_out, 0.6}, {arms_out, 0.7}, {swinging, 0.7},
     {leaning_forward, -0.6}, {long_steps, 0.5}}},
    {"shy", -0.3, -0.2, {{wide_stance, -0.4}, {head_down, 0.8}, {shoulders_up, 0.4},
     {long_steps, -0.6}, {fast, -0.5}}, with_folded_hands},
    {"sad", -0.8, -0.6, {{stooped, 0.6}, {head_down, 1}, {dragging, 0.5}, {still_arms, 0.7},
     {fast, -0.7}}},
    {"drunk", 0.1, -0.3, {{swaying, 2.2}, {toes_out, 0.7}, {arms_out, 0.8}, {leaning_forward, -1},
     {soft_knees, 1}, {fast, -0.4}}},
    {"limping", -0.5, -0.1, {{still_arms, 0.5}, {fast, -0.6}, {arms_out, 0.5},
     {leaning_forward, 0.6}}, limp},
    {"hands-in-pockets", 0.1, -0.2, {{fast, -0.4}, {leaning_forward, 0.3}, {head_down, 0.3}},
     with_hands_in_pockets},
    {"sleepwalking", 0, -0.9, {{fast, -0.8}, {dragging, 0.4}, {leaning_forward, -0.3}},
     with_arms_ahead},
    {"robot", -0.1, 0, {{stiff, 1.5}, {high_steps, 0.6}}, like_a_machine},
    {"penguin", 0.5, 0.2, {{swaying, 1.3}, {toes_out, 1.2}, {still_arms, 0.9}, {arms_out, 1.1},
     {long_steps, -1.2}, {fast, -0.5}, {bent_elbows, -0.35}}},
    {"carrying-a-bag", -0.2, 0.1, {{fast, -0.3}}, with_a_bag},
};

constexpr Member wide_members[] = {
    {"cowboy", 0.2, 0.1, {{still_arms, 0.6}, {toes_out, 0.3}, {bent_elbows, -0.4},
     {arms_forward, -0.3}, {leaning_forward, -0.4}, {fast, -0.5}}},
    {"bodybuilder", 0.3, 0.4, {{chest_out, 0.8}, {arms_out, 0.9}, {swaying, 0.7},
     {bent_elbows, -0.2}}},
    {"sumo", 0, 0.3, {{wide_stance, 0.8}, {soft_knees, 1.6}, {swaying, 0.8}, {high_steps, 0.6},
     {fast, -0.6}, {arms_forward, 0.5}}},
    {"gorilla", -0.2, 0.4, {{leaning_forward, 1.9}, {soft_knees, 1.4}, {arms_out, 0.8},
     {swaying, 1}, {bent_elbows, -0.4}, {head_down, -0.5}, {shoulders_up, 0.8}}},
    {"giant", 0, 0.2, {{long_steps, 1.2}, {fast, -0.6}, {high_steps, 0.6}, {arms_out, 0.4},
     {head_down, 0.6}, {swinging, 0.6}}},
    {"macho", 0.2, 0.5, {{chest_out, 0.6}, {swinging, 0.8}, {rolling_hips, -0.5}, {fast, 0.5}}},
    {"toddler", 0.6, 0.5, {{long_steps, -1.6}, {swaying, 0.8}, {still_arms, 0.8},
     {high_steps, 0.3}, {wide_stance, -0.3}}, with_hands_up},
    {"gunslinger", -0.2, 0.3, {{still_arms, 0.8}, {leaning_forward, 0.5}, {arms_forward, -0.6},
     {arms_out, 0.3}, {fast, -0.6}}},
    {"sailor", 0.5, 0.2, {{swaying, 1.6}, {rolling_hips, 0.7}, {toes_out, 0.4}, {swinging, 0.3},
     {bent_elbows, -0.2}}},
    {"wrestler", -0.3, 0.7, {{leaning_forward, 1}, {soft_knees, 1.1}, {arms_forward, 0.8},
     {still_arms, 0.6}, {arms_out, 0.4}}},
    {"bouncer", -0.3, 0.2, {{still_arms, 0.7}, {stiff, 0.4}, {wide_stance, -0.4},
     {head_down, 0.5}, {shoulders_up, 0.5}, {bent_elbows, 0.2}}},
    {"monster", -0.6, 0.3, {{stiff, 0.8}, {arms_forward, 1.2}, {dragging, 0.5}, {swaying, 1},
     {fast, -0.5}}},
    {"knight", 0.2, 0.2, {{stiff, 0.8}, {high_steps, 0.8}, {bent_elbows, 0.4}, {swinging, 0.4}}},
    {"bully", -0.5, 0.7, {{leaning_forward, 0.8}, {swinging, 0.9}, {shoulders_up, 0.9},
     {fast, 0.6}}},
    {"strutting", 0.6, 0.6, {{bouncing, 1.1}, {chest_out, 0.8}, {swinging, 0.5},
     {bent_elbows, 0.5}, {head_down, -0.3}}},
    {"rider", 0.1, -0.1, {{toes_out, -0.5}, {soft_knees, 0.9}, {arms_forward, 0.4},
     {still_arms, 0.6}, {wide_stance, 0.5}, {bent_elbows, 0.3}}},
    {"weightlifter", 0.1, 0.3, {{shoulders_up, 0.9}, {arms_out, 1}, {still_arms, 0.6},
     {fast, -0.7}, {swaying, 0.4}, {dragging, 0.4}}},
};
// clang-format on

double held(double quality) { return std::clamp(quality, -1.0, 1.0); }

StyleCharacter held(StyleCharacter c) {
  return {held(c.valence),    held(c.arousal), held(c.pace),  held(c.openness),   held(c.weight),
          held(c.steadiness), held(c.tension), held(c.youth), held(c.naturalness)};
}

template <std::size_t count>
void add_family(const char* name, void (*family)(GaitStyle&), const Member (&members)[count],
                std::vector<GaitStyle>& styles) {
  for (const Member& member : members) {
    GaitStyle style;
    style.name = style.style = member.name;
    style.family = name;
    family(style);
    for (const Portion& portion : member.traits) portion.trait(style, portion.amount);
    style.character.valence += member.valence;
    style.character.arousal += member.arousal;
    if (member.own) member.own(style);
    style.character = held(style.character);
    styles.push_back(std::move(style));
  }
}

}  // namespace

std::vector<GaitStyle> styles_of_set_n() {
  std::vector<GaitStyle> styles;
  add_family("crouching", crouching, crouching_members, styles);
  add_family("upright", upright, upright_members, styles);
  add_family("wide", wide, wide_members, styles);
  return styles;
}

}  // namespace promenade::motion::gait
