// A number type in which a formula writes itself as FPCore, the language of the FPBench standard, which Herbie,
// FPTaylor and other tools read: https://fpbench.org/spec/fpcore-2.0.html.
#pragma once

#include <graze/number/traits.hpp>

#include <cstddef>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace graze::inline v0_1 {

class fpcore_term;

// Collects a run: inputs by name, and each operation once, in the order in which the formula computes it.
class fpcore_script {
  public:
    // A symbol of FPCore: letters, digits and any of ~!@$%^&*_-+=<>.?/: but no digit or colon first. Throws
    // std::invalid_argument for anything else; for what FPCore reads as a number, such as -1 and .5, or as a constant,
    // such as E and PI; for a name that is taken; and for t0, t1 and so on, which name what is computed.
    [[nodiscard]] fpcore_term input(const std::string& name);

    // A fact about the inputs, an expression of FPCore such as "(< 0 R)".
    void suppose(const std::string& fact) { facts_.push_back(fact); }

    // The whole script. name: printable ASCII; throws std::invalid_argument for anything else, since FPCore's strings
    // cannot hold it. precision: "binary32", "binary64", "binary128", "real" or another that the tools know.
    [[nodiscard]] std::string text(const fpcore_term& result, const std::string& name,
                                   const std::string& precision = "binary64") const;

  private:
    friend class fpcore_term;
    std::vector<std::string> inputs_, facts_, operations_;

    static constexpr const char* digits = "0123456789";
    [[nodiscard]] static bool is_symbol(const std::string& name);
    [[nodiscard]] static bool is_constant(const std::string& name); // or a number
    [[nodiscard]] static std::string quoted(const std::string& name);
};

class fpcore_term {
  public:
    fpcore_term(int value = 0) : text_(std::to_string(value)) {}

    // A number or a name.
    [[nodiscard]] const std::string& text() const noexcept { return text_; }

    [[nodiscard]] fpcore_term operator-() const { return noted("-", {this}); }
    [[nodiscard]] friend fpcore_term operator+(const fpcore_term& x, const fpcore_term& y) {
        return noted("+", {&x, &y});
    }
    [[nodiscard]] friend fpcore_term operator-(const fpcore_term& x, const fpcore_term& y) {
        return noted("-", {&x, &y});
    }
    [[nodiscard]] friend fpcore_term operator*(const fpcore_term& x, const fpcore_term& y) {
        return noted("*", {&x, &y});
    }
    [[nodiscard]] friend fpcore_term operator/(const fpcore_term& x, const fpcore_term& y) {
        return noted("/", {&x, &y});
    }
    // x y + z, rounded once.
    [[nodiscard]] friend fpcore_term fused(const fpcore_term& x, const fpcore_term& y, const fpcore_term& z) {
        return noted("fma", {&x, &y, &z});
    }
    [[nodiscard]] friend fpcore_term square_root_of(const fpcore_term& x) { return noted("sqrt", {&x}); }

  private:
    friend class fpcore_script;
    fpcore_term(fpcore_script* script, std::string text) : script_(script), text_(std::move(text)) {}

    // An operation on numbers only belongs to no script: it is written out wherever it is used.
    [[nodiscard]] static fpcore_term noted(const char* operation, std::initializer_list<const fpcore_term*> operands) {
        std::string expression = std::string("(") + operation;
        fpcore_script* script = nullptr;
        for (const fpcore_term* x : operands) {
            expression += " " + x->text_;
            script = script != nullptr ? script : x->script_;
        }
        expression += ")";
        if (script == nullptr) {
            return {nullptr, expression};
        }
        script->operations_.push_back(expression);
        return {script, "t" + std::to_string(script->operations_.size() - 1)};
    }

    fpcore_script* script_ = nullptr;
    std::string text_;
};

inline bool fpcore_script::is_symbol(const std::string& name) {
    const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ~!@$%^&*_-+=<>.?/:";
    return !name.empty() && letters.find(name.front()) != std::string::npos && name.front() != ':' &&
           name.find_first_not_of(letters + digits) == std::string::npos;
}
inline bool fpcore_script::is_constant(const std::string& name) {
    for (const char* constant : {"E", "LOG2E", "LOG10E", "LN2", "LN10", "PI", "PI_2", "PI_4", "M_1_PI", "M_2_PI",
                                 "M_2_SQRTPI", "SQRT2", "SQRT1_2", "INFINITY", "NAN", "TRUE", "FALSE"}) {
        if (name == constant) {
            return true;
        }
    }
    const std::size_t first = name.find_first_not_of("+-."); // a sign, a point
    return first <= 2 && std::string(digits).find(name[first]) != std::string::npos;
}

inline fpcore_term fpcore_script::input(const std::string& name) {
    const bool is_ours =
        name.size() > 1 && name.front() == 't' && name.find_first_not_of(digits, 1) == std::string::npos;
    bool is_taken = false;
    for (const std::string& other : inputs_) {
        is_taken = is_taken || other == name;
    }
    const char* problem = !is_symbol(name)    ? "no symbol of FPCore"
                          : is_constant(name) ? "a number or a constant of FPCore"
                          : is_taken          ? "taken"
                          : is_ours           ? "the name of a result"
                                              : nullptr;
    if (problem != nullptr) {
        throw std::invalid_argument("fpcore_script::input: \"" + name + "\" is " + problem);
    }
    inputs_.push_back(name);
    return {this, name};
}

inline std::string fpcore_script::quoted(const std::string& name) {
    std::string text = "\"";
    for (const char c : name) {
        if (c < ' ' || c > '~') {
            throw std::invalid_argument("fpcore_script::text: the name is not of printable ASCII");
        }
        text += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    }
    return text + "\"";
}

inline std::string fpcore_script::text(const fpcore_term& result, const std::string& name,
                                       const std::string& precision) const {
    std::string text = "(FPCore (";
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
        text += (i == 0 ? "" : " ") + inputs_[i];
    }
    text += ")\n :name " + quoted(name) + "\n :precision " + precision + "\n";
    if (!facts_.empty()) {
        text += " :pre (and";
        for (const std::string& fact : facts_) {
            text += " " + fact;
        }
        text += ")\n";
    }
    if (operations_.empty()) {
        return text + " " + result.text() + ")\n";
    }
    text += " (let* (";
    for (std::size_t i = 0; i < operations_.size(); ++i) {
        text += (i == 0 ? "[t" : "\n        [t") + std::to_string(i) + " " + operations_[i] + "]";
    }
    return text + ")\n  " + result.text() + "))\n";
}

template <>
struct number_traits<fpcore_term> {
    static constexpr const char* name = "fpcore_term";
    static constexpr bool is_exact = false;
    static constexpr int digits = 0;
    // In a case distinction, the case of positive numbers is written; suppose() should say so.
    static int sign(const fpcore_term&) { return 1; }
    static fpcore_term sqrt(const fpcore_term& x) { return square_root_of(x); }
    static fpcore_term fma(const fpcore_term& x, const fpcore_term& y, const fpcore_term& z) { return fused(x, y, z); }
};

} // namespace graze::inline v0_1
