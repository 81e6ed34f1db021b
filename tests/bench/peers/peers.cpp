// peers [REPEATS [FILE.csv]]: emberleaf against Boost odeint and SUNDIALS on the swing problem, on
// one core.
#include <cstdio>
#include <cstdlib>

#include "tables.h"

int main(int argc, char** argv) {
    const int repeats = argc > 1 ? std::atoi(argv[1]) : 5;
    if (argc > 3 || repeats < 1) {
        std::fprintf(stderr, "usage: peers [REPEATS [FILE.csv]]\n");
        return 2;
    }
    std::FILE* csv = argc > 2 ? std::fopen(argv[2], "w") : nullptr;
    if (argc > 2 && csv == nullptr) {
        std::perror(argv[2]);
        return 1;
    }
    ember::peers::compare_right_hand_sides(repeats, csv);
    ember::peers::compare_solvers(repeats, csv);
    return csv != nullptr && std::fclose(csv) != 0 ? 1 : 0;
}
