#!/usr/bin/env python3
"""Runs presets with several builds, thread counts and times, and compares the state hash of every
tick.

    tests/determinism/run_matrix.py                 the whole matrix: builds below build/determinism
    tests/determinism/run_matrix.py --build gcc-O2 --build clang-O2 --ticks 300 --runs 1
    tests/determinism/run_matrix.py --binary build/dev/emberleaf --threads 1,2 --runs 1

The first run of a preset is what the others are compared with. Prints a line for every case; ends
with exit code 1 when one differs, and 2 when one could not be built or run.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

# What is not the simulation is compiled in the quickest way.
BUILDS = {
    "gcc-O2": {"sim": "-O2"},
    "gcc-O0": {"sim": "-O0"},
    "gcc-O3": {"sim": "-O3"},
    "gcc-O2-plain": {"sim": "-O2", "more": ["-DEMBERLEAF_DISPATCH=OFF"]},  # no AVX, no FMA
    "clang-O2": {"sim": "-O2",
                 "more": ["-DCMAKE_CXX_COMPILER=clang++", "-DCMAKE_C_COMPILER=clang"]},
    "gcc-asan": {"sim": "-O1", "more": ["-DEMBERLEAF_SANITIZE=address,undefined"]},
}

PRESETS = ["paper/corner", "paper/stack", "real/office", "real/cigarette", "scenes/leaf",
           "bench/swing"]


def build(name):
    """Path of the program that build `name` makes."""
    folder = ROOT / "build" / "determinism" / name
    how = BUILDS[name]
    configure = ["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                 "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DEMBERLEAF_BUILD_UI=OFF",
                 "-DEMBERLEAF_BUILD_TESTS=OFF", "-DEMBERLEAF_SIM_OPTIMISATION=" + how["sim"]]
    for command in (configure + how.get("more", []),
                    ["cmake", "--build", folder, "--target", "state_hashes"]):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            sys.stderr.write(done.stdout[-4000:])
            sys.exit(2)
    return folder / "tests" / "determinism" / "state_hashes"


def simulate(binary, preset, ticks, threads, file, settings):
    """Runs a preset and returns the lines of hashes."""
    settings = ["numerics.tick_rate=60"] + settings
    if pathlib.Path(binary).name == "state_hashes":
        command = [binary, preset, str(ticks), str(threads), file] + settings
    else:
        command = [binary, "simulate", preset, "--seconds", repr(ticks / 60.0), "--threads",
                   str(threads), "--hashes", file, "-q", "--progress", "none"]
        command += [word for setting in settings for word in ("--set", setting)]
    # the leak check does not work in every container, and is not the question here
    environment = dict(os.environ, ASAN_OPTIONS="detect_leaks=0")
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env=environment)
    if done.returncode != 0:
        words = " ".join(map(str, command))
        sys.stderr.write(f"{words}\nexit code {done.returncode}\n{done.stdout}")
        sys.exit(2)
    return file.read_text().splitlines()


def difference(expected, found):
    """What is said of two runs: "equal", or where they part."""
    for a, b in zip(expected, found):
        if a != b:
            return f"DIFFERS from tick {b.split()[0]} on: {b.split()[1]}, expected {a.split()[1]}"
    return "equal" if len(expected) == len(found) else "DIFFERS in length"


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", action="append", choices=BUILDS, help="default: all")
    parser.add_argument("--binary", action="append", help="this program instead of builds")
    parser.add_argument("--preset", action="append", help="default: " + ", ".join(PRESETS))
    parser.add_argument("--set", action="append", default=[], help="as of emberleaf simulate")
    parser.add_argument("--ticks", type=int, default=2000)
    parser.add_argument("--threads", default="1,2,3,4,8")
    parser.add_argument("--runs", type=int, default=3, help="of every case")
    parser.add_argument("--folder", default=str(ROOT / "build" / "determinism"),
                        help="where the hashes are written")
    return parser.parse_args()


def main():
    options = read_arguments()
    names = options.binary or options.build or list(BUILDS)
    threads = [int(t) for t in options.threads.split(",")]
    folder = pathlib.Path(options.folder)
    folder.mkdir(parents=True, exist_ok=True)
    different = 0
    expected = {}
    print(f"{'build':<16} {'preset':<24} threads runs  ticks      s  result", flush=True)
    for name in names:
        binary = name if options.binary else build(name)
        for preset in options.preset or PRESETS:
            for count in threads:
                start, results = time.monotonic(), []
                for _ in range(options.runs):
                    lines = simulate(binary, preset, options.ticks, count, folder / "hashes.txt",
                                     options.set)
                    results.append(difference(expected.setdefault(preset, lines), lines))
                worst = next((r for r in results if r != "equal"), "equal")
                different += worst != "equal"
                print(f"{pathlib.Path(name).name:<16} {preset:<24} {count:7} {options.runs:4} "
                      f"{options.ticks:6} {time.monotonic() - start:6.1f}  {worst}", flush=True)
    print("every state hash is equal" if different == 0 else f"{different} cases differ")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
