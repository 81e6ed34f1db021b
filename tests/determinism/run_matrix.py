#!/usr/bin/env python3
"""Runs presets with several builds, thread counts and times, and compares the state hash of every
tick.

    tests/determinism/run_matrix.py                 the whole matrix: builds below build/determinism
    tests/determinism/run_matrix.py --build gcc-O2 --build clang-O2 --preset paper/corner --ticks 300
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

# What is not the simulation is compiled in the quickest way, and once per compiler if ccache is used.
BUILDS = {
    "gcc-O2": {"sim": "-O2"},
    "gcc-O0": {"sim": "-O0"},
    "gcc-O3": {"sim": "-O3"},
    "gcc-O2-plain": {"sim": "-O2", "more": ["-DEMBERLEAF_DISPATCH=OFF"]},  # no AVX, no FMA
    "clang-O2": {"sim": "-O2", "more": ["-DCMAKE_CXX_COMPILER=clang++", "-DCMAKE_C_COMPILER=clang"]},
    "gcc-asan": {"sim": "-O1", "more": ["-DEMBERLEAF_SANITIZE=address,undefined"]},
}

PRESETS = ["paper/corner", "paper/stack", "real/office", "real/cigarette", "scenes/leaf", "bench/swing"]


def build(name):
    """Path of the program that build `name` makes."""
    folder = ROOT / "build" / "determinism" / name
    how = BUILDS[name]
    configure = ["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                 "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DEMBERLEAF_BUILD_UI=OFF",
                 "-DEMBERLEAF_BUILD_TESTS=OFF", "-DEMBERLEAF_SIM_OPTIMISATION=" + how["sim"]]
    for command in (configure + how.get("more", []), ["cmake", "--build", folder, "--target", "emberleaf"]):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            sys.stderr.write(done.stdout[-4000:])
            sys.exit(2)
    return folder / "emberleaf"


def simulate(binary, preset, ticks, threads, option, file, settings):
    """The finished process of one run; `option` is --hashes or --verify."""
    rate = 60.0
    command = [binary, "simulate", preset, "--seconds", repr(ticks / rate), "--threads", str(threads),
               option, file, "-q", "--progress", "none", "--set", "numerics.tick_rate=60"]
    for setting in settings:
        command += ["--set", setting]
    # the sanitizers' leak check does not work under every container, and is not the question here
    environment = dict(os.environ, ASAN_OPTIONS="detect_leaks=0")
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          env=environment)


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", action="append", choices=BUILDS, help="default: all")
    parser.add_argument("--binary", help="this program instead of builds")
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
    names = [options.binary] if options.binary else options.build or list(BUILDS)
    threads = [int(t) for t in options.threads.split(",")]
    folder = pathlib.Path(options.folder)
    folder.mkdir(parents=True, exist_ok=True)
    different = 0
    written = {}
    print(f"{'build':<16} {'preset':<24} threads runs  ticks      s  result", flush=True)
    for name in names:
        binary = options.binary or build(name)
        for preset in options.preset or PRESETS:
            for count in threads:
                start, problem = time.monotonic(), ""
                good = "equal" if preset in written else "written"
                for _ in range(options.runs):
                    file = folder / (preset.replace("/", "_") + ".hashes")
                    option = "--verify" if preset in written else "--hashes"
                    done = simulate(binary, preset, options.ticks, count, option, file, options.set)
                    if done.returncode not in (0, 3):
                        sys.stderr.write(f"{binary} {preset}: exit code {done.returncode}\n{done.stderr}")
                        return 2
                    written.setdefault(preset, file)
                    problem = problem or done.stderr.strip()
                different += 1 if problem else 0
                label = pathlib.Path(name).name
                print(f"{label:<16} {preset:<24} {count:7} {options.runs:4} {options.ticks:6} "
                      f"{time.monotonic() - start:6.1f}  {problem or good}", flush=True)
    print("every state hash is equal" if different == 0 else f"{different} cases differ")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
