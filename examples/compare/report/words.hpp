// The fixed texts of every report, as HTML.
#pragma once

namespace compare::report::words {

inline constexpr const char* before_title = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
)";

// The script shows a mark's name under its picture, for touch screens. Without it, the browser shows its own hint.
inline constexpr const char* after_all = R"(</main>
<script>
for (const kind of ['click', 'mouseover']) addEventListener(kind, event => {
  const point = event.target.closest('.point');
  const output = point && point.closest('figure').querySelector('output');
  if (output) output.textContent = point.firstChild.textContent;
});
</script>
)";
inline constexpr const char* end = "</body>\n</html>\n";

inline constexpr const char* navigation =
    R"(<nav><a href="#speed">Speed and error</a> <a href="#exactness">Exactness</a>
<a href="#digits">Digits</a> <a href="#decisions">Decisions</a> <a href="#distribution">Distribution</a> <a href="#hardness">Hardness</a>
<a href="#dots">Pairs</a> <a href="#tables">Tables</a></nav>
)";

inline constexpr const char* speed = R"(<h2>Speed against error</h2>
<p>Each point is one number type with one form of the discriminant and of the root. Further left is faster, further down
is more exact; the lowest line has no error at all. The green staircase joins the best of those that decided every pair
right. <span class="pointing">Point at or touch a mark to read its name.</span></p>
)";

inline constexpr const char* exactness = R"(<h2>Exactness against cost</h2>
<p>The share of the answers that differ from the exact answer rounded once: the decision is wrong or left open, or the
time is not the nearest double. Further left is faster, further down is more often right; the lowest line is always right.</p>
)";

inline constexpr const char* digits = R"(<h2>Digits wanted, and what they cost</h2>
<p>The cheapest type that decides every pair right and has every time right to this many decimal digits, over all groups.
The table has each group by itself.</p>
)";

inline constexpr const char* decisions = R"(<h2>Wrong decisions</h2>
<p>How many pairs a type took for a hit that was a miss, for overlapping, for approaching, or the other way round. Amber:
left open, by a type that says so. A type without a line here decided every pair right.</p>
)";

inline constexpr const char* distribution = R"(<h2>How the errors are distributed</h2>
<p>Of the pairs decided right, the share whose time of impact has at most this error, in units in the last place of a
double. Left and up is better; left of the dashed line a time is within half a unit.</p>
)";

inline constexpr const char* hardness = R"(<h2>Error against hardness</h2>
<p>Bits that the worst pair loses, of those that the type has, as pairs get harder. Grey is what the conditioning of the
problem explains: what rounding the inputs alone would lose. A line above the grey is the formula’s fault, a line in it the
problem’s, and a line ends where no decision was right.</p>
)";

inline constexpr const char* tables = R"(<h2>Tables</h2>
<p>Errors are the largest ones, the median in parentheses, in units in the last place that the exact value has as a
double. Momentum and energy: the largest relative change in a collision. A star marks the best of a group: nothing is both
faster and better. <span class="pointing">Folded tables are not printed.</span></p>
)";

} // namespace compare::report::words
