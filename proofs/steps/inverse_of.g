# 1/(x + xl) of inverse_of (contact/lane_steps.hpp), as written, for x within 1 and 2, which powers of two don't change, and
# xl = t x with |t| <= u = 2^-53. Proved: a relative error of at most 9.2 u², (il - r i) X - r² with X = x + xl and r = 1 - i X;
# and that il is at most 2.01 u of i before it is rounded.
@rnd = float<53, -5000, ne>;
x = rnd(x_);
i = rnd(1 / x);
p = rnd(i * x);
pe = i * x - p;
of_low = rnd(i * (x * t));
rest = rnd(rnd(rnd(1 - p) - pe) - of_low);
il = rnd(rest * i);
off = i * x - 1;
r = -off - i * (x * t);
{ x in [1,2] /\ |t| <= 1b-53
  -> |(il - r * i) * (x + x * t) - r * r| <= 0x1.2666p-103 /\ |rest| <= 0x1.0147ap-52 }
off -> (i - 1 / x) * x { x <> 0 };
1 - p -> pe - off;
i * (x * t) -> (off + 1) * t;
rest - r -> (rest - (rnd(rnd(1 - p) - pe) - of_low)) + ((rnd(rnd(1 - p) - pe) - (rnd(1 - p) - pe)) + (rnd(1 - p) - (1 - p)) - (of_low - i * (x * t)));
il - r * i -> (il - rest * i) + (rest - r) * i;
(il - r * i) * (x + x * t) -> ((il - r * i) * x) * (1 + t);
(il - r * i) * x -> (il - rest * i) * x + (rest - r) * (off + 1);
(il - rest * i) * x -> ((il - rest * i) / (rest * i)) * rest * (off + 1) { rest * i <> 0 };
