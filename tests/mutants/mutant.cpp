// Which of the planted faults is on: the number in EMBERLEAF_MUTANT, or none.
#include <cstdlib>

extern int ember_mutant;  // as the copies that plant.py writes declare it
int ember_mutant =
    std::getenv("EMBERLEAF_MUTANT") != nullptr ? std::atoi(std::getenv("EMBERLEAF_MUTANT")) : 0;
