#include "diff.hpp"

#include "text_table.hpp"

#include <algorithm>
#include <sstream>

namespace compare {

namespace {

// Times that differ by less are noise.
constexpr double notable_ratio = 1.25;

bool same_row(const row& x, const row& y) {
    return x.group == y.group && x.type == y.type && x.variant == y.variant && x.root == y.root;
}

const row* match(const std::vector<row>& rows, const row& like) {
    const auto place = std::find_if(rows.begin(), rows.end(), [&](const row& r) { return same_row(r, like); });
    return place == rows.end() ? nullptr : &*place;
}

std::string name_of(const row& r) { return r.group + ": " + r.type + " " + r.variant + "/" + r.root; }

// Notes what changed of one row, each in its list.
class row_difference {
  public:
    row_difference(difference& all, const row& before) : all_(all), name_(name_of(before)) {}

    // More is worse.
    void note(const std::string& what, double before, double after) {
        if (before != after) {
            changed_ = true;
            (after > before ? all_.worse : all_.better)
                .push_back(name_ + ": " + what + " " + short_number(before) + " -> " + short_number(after));
        }
    }
    void note(const std::string& what, std::size_t before, std::size_t after) {
        if (before != after) {
            changed_ = true;
            (after > before ? all_.worse : all_.better)
                .push_back(name_ + ": " + what + " " + std::to_string(before) + " -> " + std::to_string(after));
        }
    }
    void note_time(double before, double after) {
        if (after > before * notable_ratio || before > after * notable_ratio) {
            (after > before ? all_.slower : all_.faster)
                .push_back(name_ + ": " + short_nanoseconds(before) + " -> " + short_nanoseconds(after) + " ns");
        }
    }
    [[nodiscard]] bool changed() const { return changed_; }

  private:
    difference& all_;
    std::string name_;
    bool changed_ = false;
};

void compare_errors(row_difference& noted, const std::string& what, const error_statistics& before,
                    const error_statistics& after) {
    noted.note(what + " where 0 is due and not given", before.unscaled, after.unscaled);
    noted.note(what + " not finite", before.not_finite, after.not_finite);
    if (before.count == 0 || after.count == 0) {
        return; // a decision that changed says so
    }
    noted.note(what + ", largest error", before.largest, after.largest);
    noted.note(what + ", median error", before.median, after.median);
    if (before.count == after.count) {
        noted.note(what + ", not correctly rounded", before.count - before.correctly_rounded,
                   after.count - after.correctly_rounded);
    }
}

void compare_rows(difference& all, const row& before, const row& after) {
    row_difference noted(all, before);
    const decision_counts& x = before.decisions;
    const decision_counts& y = after.decisions;
    noted.note("wrong on approaching", x.approaching, y.approaching);
    noted.note("wrong on overlap", x.overlap, y.overlap);
    noted.note("wrong on hit or miss", x.hit_or_miss, y.hit_or_miss);
    noted.note("wrong feature", x.feature, y.feature);
    noted.note("no answer", x.failed, y.failed);
    noted.note("undecided", x.undecided, y.undecided);
    noted.note("not enclosed", before.not_enclosed, after.not_enclosed);
    for (std::size_t i = 0; i < quantity_count; ++i) {
        compare_errors(noted, quantity_names[i], before.errors[i], after.errors[i]);
    }
    if (before.width.count > 0 && after.width.count > 0) {
        noted.note("width, largest", before.width.largest, after.width.largest);
    }
    noted.note("momentum, largest defect", before.momentum.largest, after.momentum.largest);
    noted.note("energy, largest defect", before.energy.largest, after.energy.largest);
    if (before.nanoseconds && after.nanoseconds) {
        noted.note_time(*before.nanoseconds, *after.nanoseconds);
    }
    if (!noted.changed()) {
        ++all.same;
    }
}

void add_list(std::ostringstream& out, const char* heading, const std::vector<std::string>& lines) {
    if (!lines.empty()) {
        out << heading << " (" << lines.size() << ")\n";
        for (const std::string& line : lines) {
            out << "  " << line << "\n";
        }
    }
}

} // namespace

difference compare_results(const results& before, const results& after) {
    difference all;
    for (const row& old_row : before.rows) {
        const row* new_row = match(after.rows, old_row);
        if (new_row == nullptr) {
            all.only_old.push_back(name_of(old_row));
        } else if (old_row.decisions.evaluated != new_row->decisions.evaluated) {
            all.not_comparable.push_back(name_of(old_row) + ": " + std::to_string(old_row.decisions.evaluated) +
                                         " pairs -> " + std::to_string(new_row->decisions.evaluated));
        } else {
            ++all.compared;
            compare_rows(all, old_row, *new_row);
        }
    }
    for (const row& new_row : after.rows) {
        if (match(before.rows, new_row) == nullptr) {
            all.only_new.push_back(name_of(new_row));
        }
    }
    return all;
}

std::string to_text(const difference& d) {
    std::ostringstream out;
    add_list(out, "Worse", d.worse);
    add_list(out, "Better", d.better);
    add_list(out, "Slower, which only informs", d.slower);
    add_list(out, "Faster, which only informs", d.faster);
    add_list(out, "On different numbers of pairs, not compared", d.not_comparable);
    add_list(out, "In the old results only", d.only_old);
    add_list(out, "In the new results only", d.only_new);
    out << d.compared << " rows compared: " << d.same << " the same but for time; " << d.worse.size()
        << " values got worse, " << d.better.size() << " better.\n";
    return out.str();
}

} // namespace compare
