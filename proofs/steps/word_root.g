# √(d + dl) of word_root (time/word_approach.hpp), as written, for d within 1 and 4, which powers of four don't change. Proved:
# what is added to r = √d in doubles is off by at most 2^-102, beside what d is off by. root is √(d + dl): root² - r² is
# `left`, by which the rules below replace it. Gappa warns that it takes that on trust.
@rnd = float<53, -5000, ne>;
d = rnd(d_);
dl = rnd(dl_);
r = rnd(sqrt(d));
half = rnd(0.5 / r);
s = rnd(r * r);
se = r * r - s;
high = rnd(rnd(d - s) - se);
rest = rnd(high + dl);
low = rnd(rest * half);
left = (d - r * r) + dl;
off = root - r;
{ d in [1,4] /\ |dl| <= 2b-53 /\ root in [0.99,2.01] /\ |off| <= 4b-53
  -> |low - off| <= 1b-102 }
d - r * r -> (sqrt(d) - r) * (sqrt(d) + r);
d - s -> (d - r * r) + se;
high - (d - r * r) -> (high - (rnd(d - s) - se)) + (rnd(d - s) - (d - s));
rest - left -> (rest - (high + dl)) + (high - (d - r * r));
off -> left / (root + r) { root + r <> 0 };
low - left * (0.5 / r) -> (low - rest * half) + ((rest - left) * half + left * (half - 0.5 / r));
low - off -> (low - left * (0.5 / r)) + left * off * (0.5 / r) / (root + r) { root + r <> 0, r <> 0 };
