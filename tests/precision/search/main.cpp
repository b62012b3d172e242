// graze-search: the formulas of graze in float and double, and its decisions and contacts in double.
#include "run.hpp"

// Each in a file of its own, compiled so that its work is counted.
void add_float(graze::precision::subjects& list);
void add_double(graze::precision::subjects& list);
void add_decisions_double(graze::precision::subjects& list);

int main(int argc, char** argv) {
    graze::precision::subjects list;
    add_float(list);
    add_double(list);
    add_decisions_double(list);
    return search::run(argc, argv, list);
}
