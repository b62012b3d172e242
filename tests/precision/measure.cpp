#include "measure.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>

namespace precision {

namespace {

void check_names(const graze::precision::subjects& formulas) {
    std::map<std::string, const graze::precision::number_type*> types;
    for (const auto& s : formulas) {
        const graze::precision::number_type &type = s->type, &other = *types.emplace(type.name, &type).first->second;
        const auto what_it_is = [](const graze::precision::number_type& t) {
            return std::tie(t.digits, t.decimal_digits, t.lowest, t.held, t.rounded);
        };
        if (what_it_is(type) != what_it_is(other)) {
            throw std::runtime_error("two number types are called " + type.name +
                                     ": the name in number_traits tells their figures apart");
        }
    }
}

// The errors of one key, collected until all are known.
struct collected {
    figures so_far;
    std::vector<double> errors;

    void add(const verdict& v, std::size_t at) {
        figures& f = so_far;
        ++f.pairs;
        f.wrong += v.wrong ? 1 : 0;
        f.values += v.values;
        f.misrounded += v.misrounded;
        if (v.wrong && !f.wrong_at) {
            f.wrong_at = at;
        }
        if (v.misrounded != 0 && !f.misrounded_at) {
            f.misrounded_at = at;
        }
        const double largest = v.largest();
        if (largest > f.largest || (!v.errors.empty() && !f.largest_at)) {
            f.largest = largest;
            f.largest_at = at;
        }
        errors.insert(errors.end(), v.errors.begin(), v.errors.end());
    }
    figures finished() && {
        if (!errors.empty()) {
            const auto middle = errors.begin() + static_cast<std::ptrdiff_t>((errors.size() - 1) / 2);
            std::nth_element(errors.begin(), middle, errors.end());
            so_far.median = *middle;
        }
        return so_far;
    }
};

// A pair as a type holds it, with the truth about it. Types that hold all doubles share both.
template <int N>
struct question {
    pair<N> asked;
    truth<N> right;
};

template <int N>
using shared_questions = std::vector<std::shared_ptr<question<N>>>;

template <int N>
bool same(const pair<N>& p, const pair<N>& q) {
    return numbers_of(p) == numbers_of(q);
}

// The pairs of dimension N at their places in the family; the other places are empty.
template <int N>
shared_questions<N> questions_of(const family& f) {
    shared_questions<N> all(f.pairs.size());
    for (std::size_t i = 0; i < f.pairs.size(); ++i) {
        if (const auto* p = std::get_if<pair<N>>(&f.pairs[i]); p != nullptr && is_valid(*p)) {
            all[i] = std::make_shared<question<N>>(*p, truth<N>(*p));
        }
    }
    return all;
}

template <int N>
shared_questions<N> as_held(const shared_questions<N>& all, const graze::precision::number_type& type) {
    shared_questions<N> result(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i] == nullptr) {
            continue;
        }
        const auto p = held(all[i]->asked, type);
        if (p && type.rounded == nullptr && same(*p, all[i]->asked)) {
            result[i] = all[i];
        } else if (auto right = p ? truth_for(*p, type) : std::nullopt) {
            result[i] = std::make_shared<question<N>>(*p, std::move(*right));
        }
    }
    return result;
}

class family_measurement {
  public:
    family_measurement(const family& f, const plan& what) : family_(f), plan_(what) {}

    void run(const graze::precision::subjects& formulas) {
        if (std::none_of(formulas.begin(), formulas.end(), [&](const auto& s) { return may_be_chosen(*s); })) {
            return;
        }
        const auto plane = questions_of<2>(family_);
        const auto space = questions_of<3>(family_);
        std::map<std::string, std::pair<shared_questions<2>, shared_questions<3>>> of_type;
        for (const auto& formula : formulas) {
            if (!may_be_chosen(*formula)) {
                continue;
            }
            auto [place, is_new] = of_type.try_emplace(formula->type.name);
            if (is_new) {
                place->second = {as_held(plane, formula->type), as_held(space, formula->type)};
            }
            ask(*formula, place->second.first);
            ask(*formula, place->second.second);
        }
    }

    void move_to(all_figures& all) {
        for (auto& [k, c] : found_) {
            all[k] = std::move(c).finished();
        }
    }

  private:
    key key_of(const subject& s, quantity q) const { return {q, s.variant, s.type.name, family_.name}; }

    bool may_be_chosen(const subject& s) const {
        return std::any_of(std::begin(graze::precision::all_quantities), std::end(graze::precision::all_quantities),
                           [&](quantity q) { return plan_.chooses(key_of(s, q)); });
    }
    void add(const subject& s, const verdicts& found, std::size_t at) {
        for (const auto& [q, v] : found) {
            const key k = key_of(s, q);
            if (plan_.chooses(k)) {
                collected& c = found_[k];
                c.so_far.correctly_rounded = s.correctly_rounded;
                c.add(v, at);
            }
        }
    }
    template <int N>
    void ask(const subject& s, const shared_questions<N>& all) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i] == nullptr) {
                continue;
            }
            if (s.measures != quantity::order) {
                add(s, judge(s, all[i]->asked, all[i]->right), i);
            } else if (i % 2 == 1 && all[i - 1] != nullptr && is_ordered(all[i - 1]->right) &&
                       is_ordered(all[i]->right)) {
                add(s, judge(s, all[i - 1]->asked, all[i]->asked, all[i - 1]->right, all[i]->right), i);
            }
        }
    }

    const family& family_;
    const plan& plan_;
    std::map<key, collected> found_;
};

} // namespace

std::string to_string(const key& k) {
    return std::string(graze::precision::to_string(k.of)) + "/" + k.variant + "/" + k.type + "/" + k.family;
}

template <int N>
std::optional<pair<N>> held(const pair<N>& p, const graze::precision::number_type& type) {
    try {
        std::vector<double> numbers = numbers_of(p);
        for (double& x : numbers) {
            x = type.held(x);
        }
        pair<N> result = p;
        set_numbers(result, numbers);
        return is_valid(result) ? std::optional(result) : std::nullopt;
    } catch (const std::exception&) { // out of the type's range
        return std::nullopt;
    }
}
template std::optional<pair<2>> held(const pair<2>&, const graze::precision::number_type&);
template std::optional<pair<3>> held(const pair<3>&, const graze::precision::number_type&);

template <int N>
std::optional<truth<N>> truth_for(const pair<N>& p, const graze::precision::number_type& type) {
    if (type.rounded == nullptr) {
        return truth<N>(p);
    }
    const auto value = [&](double x) { return exactly(type.rounded(x)); };
    return truth<N>::of_rounded(p, value);
}
template std::optional<truth<2>> truth_for(const pair<2>&, const graze::precision::number_type&);
template std::optional<truth<3>> truth_for(const pair<3>&, const graze::precision::number_type&);

std::optional<verdict> judge_one(const subject& formula, quantity of, const any_pair& p, const any_pair* other) {
    return std::visit(
        [&]<int N>(const pair<N>& asked) -> std::optional<verdict> {
            const auto first = is_valid(asked) ? held(asked, formula.type) : std::nullopt;
            const auto about_first = first ? truth_for(*first, formula.type) : std::nullopt;
            if (!about_first) {
                return std::nullopt;
            }
            const truth<N>& right = *about_first;
            verdicts found;
            if (other == nullptr) {
                found = judge(formula, *first, right);
            } else {
                const auto second = held(std::get<pair<N>>(*other), formula.type);
                const auto about_second = second ? truth_for(*second, formula.type) : std::nullopt;
                if (!about_second || !is_ordered(right) || !is_ordered(*about_second)) {
                    return std::nullopt;
                }
                found = judge(formula, *first, *second, right, *about_second);
            }
            const auto v = found.find(of);
            return v == found.end() ? std::nullopt : std::optional(v->second);
        },
        p);
}

all_figures measure(const graze::precision::subjects& formulas, const plan& what) {
    check_names(formulas);
    all_figures all;
    std::atomic<std::size_t> next = 0;
    std::mutex lock;
    const auto work = [&] {
        for (std::size_t i = next++; i < what.families.size(); i = next++) {
            family_measurement one(what.families[i], what);
            one.run(formulas);
            const std::scoped_lock hold(lock);
            one.move_to(all);
        }
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < what.threads; ++i) {
        others.emplace_back(work);
    }
    work();
    for (std::thread& t : others) {
        t.join();
    }
    for (const family& f : what.families) {
        for (const auto& [k, measured] : all) {
            if (k.family == f.name && measured.pairs > f.pairs.size()) { // some pair was asked twice
                throw std::runtime_error("two formulas are called " + k.variant +
                                         ": the name tells their figures apart");
            }
        }
    }
    return all;
}

} // namespace precision
