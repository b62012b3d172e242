// A number type in which a formula writes the Gappa script of its own rounding error.
#pragma once

#include <graze/number/traits.hpp>

#include <map>
#include <string>
#include <utility>

namespace graze::inline v0_1 {

class gappa_term;

// The script of a run: every computed value t and the exact value m that it stands for, both by their names in Gappa.
// Each rounding is a hypothesis, t -/ (x + y) in [-u,u], that is |t - (x + y)| <= u|x + y|. With u = 2^-52 it holds for
// doubles in every rounding mode. A fused multiply-add omits a rounding, so the hypotheses stay true.
class gappa_script {
  public:
    // unit: u in Gappa's syntax.
    explicit gappa_script(std::string unit = "1b-52") : unit_(std::move(unit)) {}

    // An input that is exact, or that was rounded once; |value| <= 1.
    [[nodiscard]] gappa_term exact_input(const std::string& name);
    [[nodiscard]] gappa_term rounded_input(const std::string& name);
    // A value that, by another proof, differs from `exact` by at most `error` units u. Both are expressions and may
    // name inputs and each other: "exact_" + name is the exact value that `name` stands for.
    [[nodiscard]] gappa_term approximate_input(const std::string& name, const std::string& exact,
                                               const std::string& error);

    // A fact about computed or exact values that the formula's caller guarantees.
    void suppose(const std::string& fact) { hypotheses_ += (hypotheses_.empty() ? "   " : "/\\ ") + fact + "\n "; }

    // The whole script, with a goal: "?" asks for the smallest bound on |t - m| that Gappa finds, "[0,K]" asks to prove
    // K. pieces, if given, says how to divide the domain, in Gappa's syntax: "x in (0.5,0.7), y in 4".
    [[nodiscard]] std::string text(const gappa_term& result, const std::string& goal = "?",
                                   const std::string& pieces = "") const;

  private:
    friend class gappa_term;

    std::string unit_;
    std::string definitions_;
    std::string hypotheses_;
    std::string hints_;
    std::map<std::string, std::string> names_; // by exact expression
    int count_ = 0;
};

class gappa_term {
  public:
    gappa_term(int value)
        : computed_(value < 0 ? "(" + std::to_string(value) + ")" : std::to_string(value)), exact_(computed_) {}

    [[nodiscard]] const std::string& computed() const noexcept { return computed_; }
    [[nodiscard]] const std::string& exact() const noexcept { return exact_; }

    [[nodiscard]] gappa_term operator-() const { return {script_, "(-" + computed_ + ")", "(-" + exact_ + ")"}; }
    [[nodiscard]] friend gappa_term operator+(const gappa_term& x, const gappa_term& y) { return rounded(x, "+", y); }
    [[nodiscard]] friend gappa_term operator-(const gappa_term& x, const gappa_term& y) { return rounded(x, "-", y); }
    [[nodiscard]] friend gappa_term operator*(const gappa_term& x, const gappa_term& y) { return rounded(x, "*", y); }
    [[nodiscard]] friend gappa_term operator/(const gappa_term& x, const gappa_term& y) { return quotient(x, y); }
    // x y + z, rounded once.
    [[nodiscard]] friend gappa_term fused(const gappa_term& x, const gappa_term& y, const gappa_term& z) {
        return rounded(x.script_, x.computed_ + " * " + y.computed_ + " + " + z.computed_,
                       x.exact_ + " * " + y.exact_ + " + " + z.exact_);
    }
    [[nodiscard]] friend gappa_term square_root_of(const gappa_term& x) {
        approximates(x);
        return rounded(x.script_, "sqrt(" + x.computed_ + ")", "sqrt(" + x.exact_ + ")");
    }
    // Doubling is exact.
    [[nodiscard]] friend gappa_term doubled(const gappa_term& x) {
        return {x.script_, "(2 * " + x.computed_ + ")", "(2 * " + x.exact_ + ")"};
    }

  private:
    friend class gappa_script;
    gappa_term(gappa_script* script, std::string computed, std::string exact)
        : script_(script), computed_(std::move(computed)), exact_(std::move(exact)) {}

    [[nodiscard]] static gappa_term rounded(const gappa_term& x, const char* operation, const gappa_term& y) {
        const auto expression = [operation](const std::string& a, const std::string& b) {
            return a + " " + operation + " " + b;
        };
        return rounded(x.script_ != nullptr ? x.script_ : y.script_, expression(x.computed_, y.computed_),
                       expression(x.exact_, y.exact_));
    }
    [[nodiscard]] static gappa_term rounded(gappa_script* script, const std::string& computed,
                                            const std::string& exact) {
        const std::string number = std::to_string(script->count_++);
        const auto [known, is_new] = script->names_.try_emplace(exact, "m" + number);
        if (is_new) { // Gappa has one name for a value; its computed counterparts may differ by contraction
            script->definitions_ += known->second + " = " + exact + ";\n";
        }
        script->suppose("t" + number + " -/ (" + computed + ") in [-" + script->unit_ + "," + script->unit_ + "]");
        return {script, "t" + number, known->second};
    }

    // Tells Gappa that x approximates its exact value. From that, Gappa sees that x is not 0.
    static void approximates(const gappa_term& x) {
        if (x.computed_ != x.exact_) {
            x.script_->hints_ += x.computed_ + " ~ " + x.exact_ + ";\n";
        }
    }
    // With a hint for Gappa: x̂/ŷ - x/y = ((x̂ - x) - (x/y)(ŷ - y))/ŷ.
    [[nodiscard]] static gappa_term quotient(const gappa_term& x, const gappa_term& y) {
        const gappa_term q = rounded(x, "/", y);
        approximates(y);
        q.script_->hints_ += x.computed_ + " / " + y.computed_ + " - " + q.exact_ + " -> ((" + x.computed_ + " - " +
                             x.exact_ + ") - " + q.exact_ + " * (" + y.computed_ + " - " + y.exact_ + ")) / " +
                             y.computed_ + " { " + y.computed_ + " <> 0, " + y.exact_ + " <> 0 };\n";
        return q;
    }

    gappa_script* script_ = nullptr;
    std::string computed_, exact_;
};

inline gappa_term gappa_script::exact_input(const std::string& name) {
    suppose("|" + name + "| <= 1");
    return {this, name, name};
}
inline gappa_term gappa_script::rounded_input(const std::string& name) {
    suppose("|" + name + "| <= 1");
    suppose(name + " -/ exact_" + name + " in [-" + unit_ + "," + unit_ + "]");
    return {this, name, "exact_" + name};
}
inline gappa_term gappa_script::approximate_input(const std::string& name, const std::string& exact,
                                                  const std::string& error) {
    const std::string known = "exact_" + name;
    const std::string delta = "error_" + name + " * (" + error + ")";
    definitions_ += known + " = " + exact + ";\n" + name + " = " + known + " + " + delta + ";\n";
    suppose("error_" + name + " in [-" + unit_ + "," + unit_ + "]");
    hints_ += name + " - " + known + " -> " + delta + ";\n";
    return {this, name, known};
}
inline std::string gappa_script::text(const gappa_term& result, const std::string& goal,
                                      const std::string& pieces) const {
    const std::string error = "|" + result.computed() + " - " + result.exact() + "|";
    return definitions_ + "{\n " + hypotheses_ + "-> " + error + " in " + goal + " }\n" + hints_ +
           (pieces.empty() ? "" : error + " $ " + pieces + ";\n");
}

template <>
struct number_traits<gappa_term> {
    static constexpr const char* name = "gappa_term";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0;
    // In a case distinction, the case of positive numbers is written; a hypothesis should say so.
    static int sign(const gappa_term&) { return 1; }
    static gappa_term sqrt(const gappa_term& x) { return square_root_of(x); }
    static gappa_term fma(const gappa_term& x, const gappa_term& y, const gappa_term& z) { return fused(x, y, z); }
    static gappa_term twice(const gappa_term& x) { return doubled(x); }
};

} // namespace graze::inline v0_1
