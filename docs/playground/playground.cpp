// What the page asks of graze: runs of a scene, and decisions about a pair, in floats, in doubles and exactly. Numbers
// go through the module's memory; each procedure says what it reads and writes there.
#include <graze/classify.hpp>
#include <graze/run.hpp>
#include <graze/solve.hpp>
#include <graze/time_of_impact.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

enum class arithmetic { single, plain, exact }; // floats, doubles, graze

// One event: its time; whom ball a met, and the indices; whether it was chosen among events of one time; then position
// and velocity of a, and of b if that is a ball.
struct event_row {
    double time;
    double with, a, b;
    double chosen;
    std::array<double, 8> after;
};

std::vector<double> numbers;       // what the page writes
std::vector<event_row> events;     // what run writes
std::vector<std::uint8_t> answers; // what decide writes

// Numbers of the page, one after the other, in T.
template <class T>
class reader {
  public:
    T number() { return static_cast<T>(*next_++); }
    graze::vec<2, T> vector() {
        const T x = number();
        return {{x, number()}};
    }
    graze::ball<2, T> ball() {
        graze::ball<2, T> b{vector(), vector(), number()};
        b.mass = number();
        return b;
    }
    graze::plane<2, T> plane() { return {vector(), vector()}; }
    graze::wall<2, T> wall() { return {vector(), {{vector()}}}; }

  private:
    const double* next_ = numbers.data();
};

template <class State>
void write(const State* s, double* to) {
    if (s != nullptr) {
        const auto& ball = s->state;
        to[0] = static_cast<double>(ball.position[0]), to[1] = static_cast<double>(ball.position[1]);
        to[2] = static_cast<double>(ball.velocity[0]), to[3] = static_cast<double>(ball.velocity[1]);
    }
}

template <class Mechanics>
graze::ending run_scene(std::size_t balls, std::size_t planes, std::size_t walls, std::uint64_t most, double until) {
    using T = typename Mechanics::number;
    reader<T> in;
    std::vector<graze::ball<2, T>> b;
    std::vector<graze::plane<2, T>> p;
    std::vector<graze::wall<2, T>> w;
    while (b.size() < balls) {
        b.push_back(in.ball());
    }
    while (p.size() < planes) {
        p.push_back(in.plane());
    }
    while (w.size() < walls) {
        w.push_back(in.wall());
    }
    graze::run<Mechanics> run(graze::scene<2, T>{.balls = b, .planes = p, .walls = w});
    return run
        .advance({.time = static_cast<T>(until), .events = most},
                 [](const auto& e) {
                     event_row row{static_cast<double>(static_cast<T>(e.when)),
                                   static_cast<double>(e.who.with),
                                   static_cast<double>(e.who.a),
                                   static_cast<double>(e.who.b),
                                   e.chosen ? 1.0 : 0.0,
                                   {}};
                     write(&e.after_a, row.after.data());
                     write(e.after_b, row.after.data() + 4);
                     events.push_back(row);
                 })
        .why;
}

template <class T>
graze::encounter textbook(const graze::ball<2, T>& a, const graze::ball<2, T>& b) {
    return graze::solve<graze::variant::textbook>(a, b).what;
}

} // namespace

extern "C" {

// Room for so many numbers of the page.
[[clang::export_name("room")]] double* room(int count) {
    numbers.resize(static_cast<std::size_t>(count));
    return numbers.data();
}

// Reads balls (position, velocity, radius, mass), planes (point, normal) and walls (corner, edge), and runs them up to
// so many events or a time. The result is the ending; the events are at `first_event`.
[[clang::export_name("run")]] int run(int how, int balls, int planes, int walls, int most, double until) {
    events.clear();
    const auto size = [](int n) { return static_cast<std::size_t>(n); };
    const auto go = [&]<class Mechanics>() {
        return static_cast<int>(run_scene<Mechanics>(size(balls), size(planes), size(walls), size(most), until));
    };
    switch (static_cast<arithmetic>(how)) {
    case arithmetic::single:
        return go.operator()<graze::plain_mechanics<2, float>>();
    case arithmetic::plain:
        return go.operator()<graze::plain_mechanics<2, double>>();
    default:
        return go.operator()<graze::exact_mechanics<2, double>>();
    }
}
[[clang::export_name("event_count")]] int event_count() { return static_cast<int>(events.size()); }
[[clang::export_name("first_event")]] const event_row* first_event() { return events.data(); }

// Reads two balls and decides, for each of side × side positions of the first one, `step` apart around its own, row by
// row from the lowest y: the encounters are bytes from the result on.
[[clang::export_name("decide")]] const std::uint8_t* decide(int how, int side, double step) {
    answers.clear();
    reader<double> in;
    const auto a = in.ball();
    const auto b = in.ball();
    const auto narrow = [](const graze::ball<2>& x) {
        const auto f = [](double y) { return static_cast<float>(y); };
        return graze::ball<2, float>{
            {{f(x.position[0]), f(x.position[1])}}, {{f(x.velocity[0]), f(x.velocity[1])}}, f(x.radius)};
    };
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            auto moved = a;
            moved.position[0] += (i - side / 2) * step;
            moved.position[1] += (j - side / 2) * step;
            const auto what = how == static_cast<int>(arithmetic::single)  ? textbook(narrow(moved), narrow(b))
                              : how == static_cast<int>(arithmetic::plain) ? textbook(moved, b)
                                                                           : graze::classify(moved, b);
            answers.push_back(static_cast<std::uint8_t>(what));
        }
    }
    return answers.data();
}

// Reads two balls: the time at which they meet, correctly rounded or by the textbook's formulas; NaN if they do not
// meet.
[[clang::export_name("time_of")]] double time_of(int how) {
    reader<double> in;
    const auto a = in.ball();
    const auto b = in.ball();
    if (how == static_cast<int>(arithmetic::exact)) {
        const auto time = graze::time_of_impact(a, b);
        return time ? static_cast<double>(*time) : std::numeric_limits<double>::quiet_NaN();
    }
    const auto s = graze::solve<graze::variant::textbook>(a, b);
    return graze::is_collision(s.what) ? s.time : std::numeric_limits<double>::quiet_NaN();
}

} // extern "C"
