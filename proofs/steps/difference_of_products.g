# a b - c d of difference_of_products (time/word_cross.hpp), as written but for its last sum, of high parts of at most 1 and
# low parts of at most u = 2^-53. Proved: what is added to the two leading parts is off by at most 2^-101, which is 2^-50 of
# the four products of a high and a low part.
@rnd = float<53, -5000, ne>;
a = rnd(a_);
al = rnd(al_);
b = rnd(b_);
bl = rnd(bl_);
c = rnd(c_);
cl = rnd(cl_);
d = rnd(d_);
dl = rnd(dl_);
p = rnd(a * b);
pe = a * b - p;
q = rnd(c * d);
qe = c * d - q;
h = rnd(p - q);
he = (p - q) - h;
e = rnd(pe - qe);
ee = (pe - qe) - e;
m = rnd(he + e);
me = (he + e) - m;
s = rnd(h + m);
se = (h + m) - s;
rest = rnd(rnd(me + ee) + rnd(rnd(rnd(a * bl) + rnd(al * b)) - rnd(rnd(c * dl) + rnd(cl * d))));
known = (me + ee) + ((a * bl + al * b) - (c * dl + cl * d));
left = al * bl - cl * dl;
{ |a_| <= 1 /\ |al_| <= 1b-53 /\ |b_| <= 1 /\ |bl_| <= 1b-53 /\ |c_| <= 1 /\ |cl_| <= 1b-53 /\ |d_| <= 1 /\ |dl_| <= 1b-53
  -> |(rest - known) - left| <= 1b-101 }
