// What fpcore_term writes is FPCore by the published grammar (FPCore 2.0), and computes what the formula computes.
#include <graze/analysis/fpcore_term.hpp>

#include <graze/formula/discriminant.hpp>
#include <graze/formula/roots.hpp>

#include <doctest/doctest.h>

#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// An s-expression: a symbol, number, string or property name, or a list in () or [].
struct node {
    std::string atom;
    std::vector<node> items;
    bool is_list = false;
};

// The grammar's terminals: https://fpbench.org/spec/fpcore-2.0.html.
bool is_symbol(const std::string& s) {
    const std::string others = "~!@$%^&*_-+=<>.?/:";
    const auto is_letter = [&](char c) {
        return std::isalpha(static_cast<unsigned char>(c)) != 0 || others.find(c) != std::string::npos;
    };
    bool good = !s.empty() && is_letter(s.front()) && s.front() != ':';
    for (const char c : s) {
        good = good && (is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0);
    }
    return good;
}
bool is_number(const std::string& s) { // only whole numbers are ever written
    const std::size_t from = s.starts_with('-') || s.starts_with('+') ? 1 : 0;
    return s.size() > from && s.find_first_not_of("0123456789", from) == std::string::npos;
}
bool is_string(const std::string& s) { return s.size() >= 2 && s.front() == '"' && s.back() == '"'; }

class parser {
  public:
    explicit parser(const std::string& text) : text_(text) {}
    node parse() {
        const node n = one();
        if (skip(); at_ != text_.size()) {
            throw std::runtime_error("more than one expression");
        }
        return n;
    }

  private:
    const std::string& text_;
    std::size_t at_ = 0;

    void skip() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
    }
    node one() {
        skip();
        if (at_ == text_.size()) {
            throw std::runtime_error("the end within an expression");
        }
        node n;
        if (text_[at_] == '(' || text_[at_] == '[') {
            const char close = text_[at_++] == '(' ? ')' : ']';
            n.is_list = true;
            for (skip(); at_ < text_.size() && text_[at_] != close; skip()) {
                n.items.push_back(one());
            }
            if (at_++ == text_.size()) {
                throw std::runtime_error("a parenthesis is open");
            }
            return n;
        }
        const std::size_t from = at_;
        if (text_[at_] == '"') {
            for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
                at_ += text_[at_] == '\\' ? 1 : 0;
            }
            ++at_;
        } else {
            while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) == 0 &&
                   std::string("()[]").find(text_[at_]) == std::string::npos) {
                ++at_;
            }
        }
        n.atom = text_.substr(from, at_ - from);
        if (n.atom.empty()) {
            throw std::runtime_error("a parenthesis too many");
        }
        return n;
    }
};

const std::map<std::string, std::size_t> operators = {{"+", 2}, {"-", 2}, {"*", 2}, {"/", 2}, {"fma", 3}, {"sqrt", 1}};

// Evaluates the expressions that formulas need: numbers, bound symbols, operations, let*.
double value_of(const node& n, std::map<std::string, double> bound) {
    if (!n.is_list) {
        if (is_number(n.atom)) {
            return std::stod(n.atom);
        }
        if (!is_symbol(n.atom) || !bound.contains(n.atom)) {
            throw std::runtime_error("not a number or a bound symbol: " + n.atom);
        }
        return bound[n.atom];
    }
    const std::string& head = n.items.at(0).atom;
    if (head == "let*") {
        if (n.items.size() != 3 || !n.items[1].is_list) {
            throw std::runtime_error("let* takes bindings and a body");
        }
        for (const node& binding : n.items[1].items) {
            if (binding.items.size() != 2 || !is_symbol(binding.items[0].atom)) {
                throw std::runtime_error("a binding is a symbol and an expression");
            }
            bound[binding.items[0].atom] = value_of(binding.items[1], bound);
        }
        return value_of(n.items[2], bound);
    }
    const auto known = operators.find(head);
    const std::size_t operands = n.items.size() - 1;
    if (known == operators.end() || (operands != known->second && !(head == "-" && operands == 1))) {
        throw std::runtime_error("not an operation: " + head);
    }
    std::vector<double> x;
    for (std::size_t i = 1; i < n.items.size(); ++i) {
        x.push_back(value_of(n.items[i], bound));
    }
    return head == "+"      ? x[0] + x[1]
           : head == "*"    ? x[0] * x[1]
           : head == "/"    ? x[0] / x[1]
           : head == "sqrt" ? std::sqrt(x[0])
           : head == "fma"  ? std::fma(x[0], x[1], x[2])
           : operands == 1  ? -x[0]
                            : x[0] - x[1];
}

// Evaluates (FPCore (argument*) property* expr). Throws if the text is anything else.
double run(const std::string& text, const std::map<std::string, double>& arguments) {
    const node core = parser(text).parse();
    if (!core.is_list || core.items.size() < 3 || core.items[0].atom != "FPCore" || !core.items[1].is_list) {
        throw std::runtime_error("no FPCore");
    }
    std::set<std::string> names;
    for (const node& argument : core.items[1].items) {
        if (!is_symbol(argument.atom) || !names.insert(argument.atom).second) {
            throw std::runtime_error("no argument: " + argument.atom);
        }
    }
    for (std::size_t i = 2; i + 1 < core.items.size(); i += 2) {
        const node& key = core.items[i];
        if (key.is_list || key.atom.size() < 2 || key.atom.front() != ':' || !is_symbol(key.atom.substr(1)) ||
            i + 2 >= core.items.size()) {
            throw std::runtime_error("a property is a name after a colon, and a value");
        }
        if (key.atom == ":name" && !is_string(core.items[i + 1].atom)) {
            throw std::runtime_error("a name is a string");
        }
        if (key.atom == ":precision" && !is_symbol(core.items[i + 1].atom)) {
            throw std::runtime_error("a precision is a symbol");
        }
    }
    return value_of(core.items.back(), arguments);
}

template <class T, class Number>
graze::relative_motion<2, T, T, T> motion(Number number) {
    graze::relative_motion<2, T, T, T> m{};
    m.dx = {{number("x", 3.1), number("y", -0.7)}};
    m.du = {{number("u", -1.3), number("v", 0.2)}};
    m.R = number("R", 0.9);
    return m;
}

} // namespace

TEST_CASE("formulas are written as FPCore, and it computes what they compute") {
    using graze::fpcore_term;
    const auto as_double = motion<double>([](const char*, double x) { return x; });
    const auto q = graze::quadratic<double, double, double>(graze::quadratic_of(as_double));
    const auto check = [&](auto formula, double expected) {
        graze::fpcore_script script;
        std::map<std::string, double> arguments;
        const auto m = motion<fpcore_term>([&](const char* name, double x) {
            arguments[name] = x;
            return script.input(name);
        });
        script.suppose("(< 0 R)");
        const std::string text = script.text(formula(m), "a formula");
        CAPTURE(text);
        CHECK(run(text, arguments) == expected);
        CHECK(text.find(":precision binary64") != std::string::npos);
        CHECK(text.find(":pre (and (< 0 R))") != std::string::npos);
    };
    const auto quadratic = [](const auto& m) {
        return graze::quadratic<fpcore_term, fpcore_term, fpcore_term>(graze::quadratic_of(m));
    };
    check([&](const auto& m) { return fpcore_term(graze::discriminant_textbook{}(quadratic(m))); },
          graze::discriminant_textbook{}(q));
    check([&](const auto& m) { return fpcore_term(graze::discriminant_halved{}(quadratic(m))); },
          graze::discriminant_halved{}(q));
    check([&](const auto& m) { return fpcore_term(graze::discriminant_kahan{}(quadratic(m))); },
          graze::discriminant_kahan{}(q));
    check([&](const auto& m) { return fpcore_term(graze::discriminant_lagrange{}(m)); },
          graze::discriminant_lagrange{}(as_double));
    check([&](const auto& m) { return graze::number_traits<fpcore_term>::sqrt(-m.R / m.dx[1]); },
          std::sqrt(-as_double.R / as_double.dx[1]));
}

TEST_CASE("what is no FPCore is told apart") {
    CHECK(run("(FPCore (x) :name \"n\" (+ x 1))", {{"x", 2}}) == 3);
    for (const char* wrong :
         {"", "(FPCore (x))", "(FPCore (x) (+ x))", "(FPCore (x) (+ x y))", "(FPCore (1) 2)", "(FPCore (x x) x)",
          "(FPCore (x) name x)", "(FPCore (x) :name n x)", "(FPCore (x) (let* ([t]) x))", "(FPCore (x) x) 1",
          "(FPCore (x) (+ x 1)", "(FPCore (x) (power x 2))"}) {
        CAPTURE(wrong);
        CHECK_THROWS(run(wrong, {{"x", 2}}));
    }
}

TEST_CASE("names that are no symbols are refused") {
    graze::fpcore_script script;
    static_cast<void>(script.input("dx_0"));
    for (const char* wrong : {"", "dx[0]", "1x", "a b", "t0", "dx_0", "\"x\"", "x;y", ":x", "-1", "+2/3", ".5", "-.5e3",
                              "-0x1p3", "E", "PI", "M_2_SQRTPI", "NAN", "TRUE"}) {
        CAPTURE(wrong);
        CHECK_THROWS_AS(static_cast<void>(script.input(wrong)), std::invalid_argument);
    }
}

TEST_CASE("a name is a string of FPCore, whatever is in it") {
    graze::fpcore_script script;
    const graze::fpcore_term x = script.input("e"), minus = script.input("-");
    const std::string text = script.text(x + minus, R"(the "halved" one, a\b)");
    CHECK(text.find(R"(:name "the \"halved\" one, a\\b")") != std::string::npos);
    CHECK(run(text, {{"e", 1}, {"-", 2}}) == 3);
    CHECK_THROWS_AS(static_cast<void>(script.text(x, "h² - ac")), std::invalid_argument);
    CHECK_THROWS_AS(static_cast<void>(script.text(x, "two\nlines")), std::invalid_argument);
}
