# u + w of exchange_velocities (contact/equal_masses.hpp), as written, for a velocity u of at most 1 and w = high + low, high
# of at most 1 and low of at most 2^-52. Proved: the low part is off by at most 2^-105 before the bound is added. Powers of two
# change nothing, so the larger of |u| and |high| is above 1/2, as is |u + w| + |high|: at most 2^-104 of that, of which 2^-103 is
# allowed.
@rnd = float<53, -5000, ne>;
u = rnd(u_);
high = rnd(high_);
low = rnd(low_);
sum = rnd(u + high);
error = (u + high) - sum;
rest = rnd(error + low);
{ |u_| <= 1 /\ |high_| <= 1 /\ |low_| <= 2b-53
  -> |rest - (error + low)| <= 1b-105 }
