// environment_check FILE [--started-flushing]: asks the predicates the questions of the file, in every rounding mode,
// with and without subnormals, and in the state in which the process started. Exit code 0: every answer is the file's;
// 1: some are not; 77: the process should have started with subnormals flushed to zero but did not.
#include "callers.hpp"
#include "state.hpp"
#include "subject.hpp"
#include "text_file.hpp"

#include <charconv>
#include <cstdio>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace environments {
namespace {

struct question {
    const subject* about;
    int answer;
    std::vector<std::uint64_t> bits;
    std::string line;
};

// The lines about the subjects known here. Each subject must occur as often as the head of the file says.
class question_file {
  public:
    question_file(const char* path, const std::vector<subject>& subjects) {
        for (const subject& s : subjects) {
            subjects_.emplace(s.name, &s);
        }
        std::istringstream file(text_of(path));
        std::size_t announced = 0, lines = 0;
        for (std::string line; std::getline(file, line);) {
            std::istringstream words(line);
            std::string word;
            words >> word;
            if (word == "subject") {
                read_subject(words);
            } else if (word == "questions") {
                words >> announced;
            } else {
                read_question(line);
                ++lines;
            }
        }
        if (lines == 0 || lines != announced) {
            throw std::runtime_error(std::string(path) + ": " + std::to_string(lines) + " questions, " +
                                     std::to_string(announced) + " announced");
        }
        for (const auto& [name, s] : subjects_) {
            if (expected_[name] == 0 || read_[name] != expected_[name]) {
                throw std::runtime_error(name + ": " + std::to_string(read_[name]) + " questions, " +
                                         std::to_string(expected_[name]) + " announced");
            }
        }
        left_out_ = lines - questions_.size();
    }

    [[nodiscard]] const std::vector<question>& questions() const { return questions_; }
    [[nodiscard]] std::size_t left_out() const { return left_out_; }

  private:
    void read_subject(std::istringstream& words) {
        std::size_t count = 0;
        std::string name;
        words >> count >> std::ws;
        std::getline(words, name);
        expected_[name] = count;
    }

    void read_question(const std::string& line) {
        std::size_t end = 0; // after the subject's four words
        for (int word = 0; word < 4; ++word) {
            end = line.find(' ', end + 1);
        }
        const auto known = subjects_.find(line.substr(0, end));
        if (known == subjects_.end()) {
            return;
        }
        question q{known->second, 0, {}, line};
        std::istringstream words(line.substr(end));
        std::string family, number;
        words >> family >> q.answer;
        while (words >> number) {
            std::uint64_t bits = 0;
            const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), bits, 16);
            if (error != std::errc() || stop != number.data() + number.size()) {
                throw std::runtime_error("not a number: " + number);
            }
            q.bits.push_back(bits);
        }
        if (q.bits.size() != q.about->numbers) {
            throw std::runtime_error("too many or too few numbers: " + line);
        }
        ++read_[q.about->name];
        questions_.push_back(std::move(q));
    }

    std::map<std::string, const subject*> subjects_;
    std::map<std::string, std::size_t> expected_, read_;
    std::vector<question> questions_;
    std::size_t left_out_ = 0;
};

struct tally {
    unsigned long answers = 0, filter = 0, exact = 0, wrong = 0;
};

class checker {
  public:
    explicit checker(const question_file& file) : file_(file) {}

    void check(const std::string& mode) {
        tally t;
        for (const question& q : file_.questions()) {
            const reply r = q.about->ask(q.bits.data());
            ++t.answers;
            t.filter += static_cast<unsigned long>(r.filter);
            t.exact += static_cast<unsigned long>(r.exact);
            if (r.answer != q.answer) {
                ++t.wrong;
                if (wrong_.size() < 10) {
                    wrong_.push_back(mode + ": " + std::to_string(r.answer) + " instead of: " + q.line);
                }
            }
        }
        const caller_tally callers = ask_callers();
        callers_.asked += callers.asked;
        callers_.different += callers.different;
        modes_.emplace_back(mode, t);
        total_.answers += t.answers;
        total_.filter += t.filter;
        total_.exact += t.exact;
        total_.wrong += t.wrong;
    }

    // Prints the table and what was wrong. Returns whether all is well.
    [[nodiscard]] bool report() const {
        std::printf("%-34s %9s %9s %9s %6s\n", "", "answers", "filter", "exact", "wrong");
        for (const auto& [mode, t] : modes_) {
            print(mode, t);
        }
        print("total", total_);
        std::printf("%lu questions of the file are about what was not compiled here\n",
                    static_cast<unsigned long>(file_.left_out()));
        for (const std::string& line : wrong_) {
            std::printf("wrong: %s\n", line.c_str());
        }
        std::printf("%lu pairs asked in a caller's arithmetic, of which %lu were answered otherwise than from memory\n",
                    callers_.asked, callers_.different);
        if (total_.filter == 0 || total_.exact == 0) {
            std::printf("one of the stages decided nothing\n");
        }
        return callers_.asked != 0 && callers_.different == 0 && total_.wrong == 0 && total_.answers != 0 &&
               total_.filter != 0 && total_.exact != 0;
    }

  private:
    static void print(const std::string& mode, const tally& t) {
        std::printf("%-34s %9lu %9lu %9lu %6lu\n", mode.c_str(), t.answers, t.filter, t.exact, t.wrong);
    }

    const question_file& file_;
    std::vector<std::pair<std::string, tally>> modes_;
    std::vector<std::string> wrong_;
    tally total_;
    caller_tally callers_;
};

int run(const char* path, bool must_start_flushing) {
    save_state();
    const bool started_flushing = flushes();
    std::vector<subject> subjects;
    add_balls_and_planes(subjects);
    add_walls(subjects);
    add_times(subjects);
    const question_file file(path, subjects);

    if (must_start_flushing && !started_flushing) {
        std::printf("SKIPPED: the process does not start with subnormals flushed to zero\n");
        return 77;
    }
    checker checks(file);
    checks.check(started_flushing ? "as started (flushing)" : "as started");
    for (const bool flush : {false, true}) {
        if (flush && !can_flush()) {
            std::printf("this machine does not flush subnormals to zero\n");
            continue;
        }
        for (const rounding r : {rounding::nearest, rounding::upward, rounding::downward, rounding::towards_zero}) {
            if (!can_round(r)) {
                std::printf("this machine does not round %s\n", name_of(r));
                continue;
            }
            const std::string mode = std::string(name_of(r)) + (flush ? ", flushing" : "");
            if (!set_state(r, flush)) {
                restore_state();
                throw std::runtime_error("the machine does not calculate " + mode);
            }
            checks.check(mode);
        }
    }
    restore_state();
    return checks.report() ? 0 : 1;
}

} // namespace
} // namespace environments

int main(int argc, char** argv) {
    const bool must_start_flushing = argc == 3 && std::string_view(argv[2]) == "--started-flushing";
    if (argc != 2 && !must_start_flushing) {
        std::fprintf(stderr, "environment_check FILE [--started-flushing]\n");
        return 2;
    }
    try {
        return environments::run(argv[1], must_start_flushing);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "environment_check: %s\n", e.what());
        return 1;
    }
}
