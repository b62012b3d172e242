# x y of add_triples (time/sharp_discriminant.hpp), of numbers in three doubles of at most 1, u and u², u = 2^-53, as written.
# Its terms but the last are exact products in two doubles each. Proved: the last and what is left out are off by at most
# 8 u³ of the largest product, 1.
@rnd = float<53, -5000, ne>;
x0 = rnd(x0_);
x1 = rnd(x1_);
x2 = rnd(x2_);
y0 = rnd(y0_);
y1 = rnd(y1_);
y2 = rnd(y2_);
p = rnd(x0 * y0);
pe = x0 * y0 - p;
q = rnd(x0 * y1);
qe = x0 * y1 - q;
r = rnd(x1 * y0);
re = x1 * y0 - r;
last = rnd(rnd(x1 * y1) + rnd(rnd(x0 * y2) + rnd(x2 * y0)));
rest = x1 * y1 + (x0 * y2 + x2 * y0);
left = x1 * y2 + x2 * y1 + x2 * y2;
{ |x0_| <= 1 /\ |x1_| <= 1b-53 /\ |x2_| <= 1b-106 /\ |y0_| <= 1 /\ |y1_| <= 1b-53 /\ |y2_| <= 1b-106
  -> |(last - rest) - left| <= 1b-156 }
