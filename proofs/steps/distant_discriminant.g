# D = h0² + a Q of approach_from_afar (time/distant_approach.hpp), as written, from y, Δu and R in doubles of components of at
# most 1. Proved: beside what these are off by it is off by at most 85.5 u, u = 2^-53. Where components are alike, a = 3 and
# P = 4: the 26.1 u a P that are allowed for both are 313 u.
@rnd = float<53, -5000, ne>;
y0 = rnd(y0_);
y1 = rnd(y1_);
y2 = rnd(y2_);
u0 = rnd(u0_);
u1 = rnd(u1_);
u2 = rnd(u2_);
r = rnd(r_);
a rnd= u0 * u0 + u1 * u1 + u2 * u2;
h rnd= y0 * u0 + y1 * u1 + y2 * u2;
d rnd= y0 * y0 + y1 * y1 + y2 * y2;
rr rnd= r * r;
q rnd= d - rr;
discriminant rnd= h * h - a * q;
ea = u0 * u0 + u1 * u1 + u2 * u2;
eh = y0 * u0 + y1 * u1 + y2 * u2;
eq = (y0 * y0 + y1 * y1 + y2 * y2) - r * r;
{ |y0_| <= 1 /\ |y1_| <= 1 /\ |y2_| <= 1 /\ |u0_| <= 1 /\ |u1_| <= 1 /\ |u2_| <= 1 /\ |r_| <= 1
  -> |discriminant - (eh * eh - ea * eq)| <= 171b-54 }
