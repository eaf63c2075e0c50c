// How a built-in walk was meant: a few qualities that shaped it, for whoever judges
// walks without seeing them (simulated raters).
#pragma once

namespace promenade::motion {

// Each from -1 to 1; 0 is a normal, neutral walk. Valence and arousal are the axes of
// Russell's circle of emotions; the others are ours.
struct StyleCharacter {
  double valence = 0;      // unpleasant .. pleasant
  double arousal = 0;      // sleepy .. aroused
  double pace = 0;         // slow .. fast
  double openness = 0;     // closed and small .. open and large
  double weight = 0;       // light-footed .. heavy
  double steadiness = 0;   // swaying, unsure .. steady, sure
  double tension = 0;      // relaxed .. tense
  double youth = 0;        // old .. childlike
  double naturalness = 0;  // artificial, posed .. unaffected
};

}  // namespace promenade::motion
