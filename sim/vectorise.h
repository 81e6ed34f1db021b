// Compiles a loop for several instruction sets and picks the best at run time.
#pragma once

// Without fused multiply-add (-ffp-contract=off) and reassociation every version computes the same
// bits; wider registers only do more elements at once. The sanitizers cannot look into the
// resolver functions that this makes, so their builds have the plain version only, as has one with
// -DEMBERLEAF_DISPATCH=OFF.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(EMBER_PLAIN) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define EMBER_VECTORISED __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define EMBER_VECTORISED
#endif
