#!/usr/bin/env python3
"""Switches planted faults on, one at a time, and looks whether the tests notice.

    tests/mutants/run_mutants.py --docs         all of them; writes docs/MUTANTS.md
    tests/mutants/run_mutants.py 11 24 103      these, by their numbers
    tests/mutants/run_mutants.py --solver       the solver's, as ./test does

Faults of the solver are looked for by the tests that the table names for each, faults of the
renderer in pictures (test_render_mutants.cpp). Ends with exit code 1 when one goes unnoticed. The
programs are built by `cmake --build --preset dev --target sim_mutated render_mutated`.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LONGEST = 600  # [s] that the tests for one fault may take


def table(name):
    return tomllib.loads((HERE / name).read_text())["mutant"]


def run_tests(program, number, tests):
    """Exit code and output of `tests` with mutant `number`; code None: they did not end."""
    environment = dict(os.environ, EMBERLEAF_MUTANT=str(number))
    command = [program, "--gtest_filter=" + tests, "--gtest_fail_fast", "--gtest_brief=1"]
    try:
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, done.stdout


def solver_verdict(program, m):
    """The test that notices mutant `m`, or why none does: (noticed, text)."""
    code, output = run_tests(program, m["number"], m["tests"])
    failed = re.search(r"\[  FAILED  \] ([\w/]+\.[\w/]+)", output)
    if code is None:
        return False, "the tests do not end"
    if code < 0:
        return False, f"the tests are ended by signal {-code}"
    if code == 0 or not failed:
        return False, "no test fails"
    if not re.search(m.get("says", ""), output, re.DOTALL):
        return False, f"{failed[1]} does not say \"{m['says']}\""
    return True, failed[1]


def try_solver(program, mutants, rows):
    """Number of mutants that go unnoticed; appends a row for each."""
    names = ":".join(sorted({m["tests"] for m in mutants}))
    code, output = run_tests(program, 0, names)
    if code != 0:
        print(output)
        sys.exit("without a fault these tests must pass")
    unnoticed = 0
    for m in mutants:
        start = time.monotonic()
        noticed, text = solver_verdict(program, m)
        unnoticed += 0 if noticed else 1
        print(f"{m['number']:4} {'noticed by' if noticed else 'UNNOTICED:'} {text} "
              f"({time.monotonic() - start:.1f} s): {m['fault']}", flush=True)
        by = text if noticed else f"**{text}**"
        rows.append(f"| {m['number']} | `{m['file']}` | {m['fault']} | {by} |")
    return unnoticed


def try_renderer(program, mutants, rows):
    """The same for mutants of the renderer."""
    unnoticed = 0
    only = {} if len(mutants) != 1 else {"EMBERLEAF_MUTANT": str(mutants[0]["number"])}
    done = subprocess.run([program], env=dict(os.environ, **only), stdout=subprocess.PIPE,
                          text=True)
    lines = dict(re.findall(r"^mutant (\d+) (.*)$", done.stdout, re.MULTILINE))
    wanted = [m for m in mutants if str(m["number"]) in lines]
    if len(wanted) != len(mutants):
        print(done.stdout)
        sys.exit("the pictures could not be drawn")
    for m in wanted:
        line = lines[str(m["number"])]
        exact, close, pixels, far, block = re.fullmatch(
            r"exact=(.*) close=(.*) pixels=(\d+) far=(\d+) block=(.*)", line).groups()
        unnoticed += 1 if exact == "-" else 0
        print(f"{m['number']:4} {line}: {m['fault']}", flush=True)
        rows.append(f"| {m['number']} | `{m['file']}` | {m['fault']} | {exact} | "
                    f"{close if close != '-' else '**-**'} | {pixels} | {far} | {block} |")
    return unnoticed + (1 if done.returncode != 0 else 0)


def check_docs(mutants):
    """Whether docs/MUTANTS.md has a line for every mutant and for no other; says what it lacks."""
    text = (ROOT / "docs" / "MUTANTS.md").read_text()
    lines = {f"| {m['number']} | `{m['file']}` | {m['fault']} |" for m in mutants}
    stale = sorted(line for line in lines if line not in text)
    if len(re.findall(r"^\| \d+ \|", text, re.MULTILINE)) != len(lines):
        stale.append("another number of lines")
    for line in stale:
        print(f"docs/MUTANTS.md is out of date ({line}); run tests/mutants/run_mutants.py --docs")
    return len(stale)


def write_docs(solver, renderer):
    close = sum("**-**" not in row for row in renderer)
    caught = sum("**" not in row for row in solver)
    text = f"""# Mutants

What would the tests notice? Faults are planted in a build of their own, one is switched on at a
time, and the tests have to fail. Nothing of this is in the program: `tests/mutants/plant.py` makes
copies of the sources from tables of faults, `tests/mutants/solver.toml` and
`tests/mutants/render.toml`, and refuses when a table no longer fits the sources. `./test` tries all
of them. By hand, and this page:

    cmake --build --preset dev --target sim_mutated render_mutated
    tests/mutants/run_mutants.py --docs

One alone, by its number: `EMBERLEAF_MUTANT=24 build/dev/tests/mutants/sim_mutated`.

## Solver: {caught} of {len(solver)} noticed

Each by the named test, the first of `tests/sim` that fails.

| number | file | fault | noticed by |
|---|---|---|---|
""" + "\n".join(solver) + f"""

## Renderer: {len(renderer)} faults, {close} noticed by the second tier too

Pictures of 240 x 135 pixels of shipped presets, compared with those that are drawn without a fault
by the same program. The first tier is equality; the second one, for another version of the
rasteriser, has the limits of the goldens (`docs/GOLDEN.md`). Named are the first pictures in which
each notices; pixels that differ, those of them that do by more than two levels, and the worst block
[levels] are the most of the pictures drawn until both had noticed.

| number | file | fault | exact | second tier | pixels | far | block |
|---|---|---|---|---|---|---|---|
""" + "\n".join(renderer) + "\n"
    (ROOT / "docs" / "MUTANTS.md").write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("numbers", nargs="*", type=int)
    parser.add_argument("--docs", action="store_true", help="write docs/MUTANTS.md")
    parser.add_argument("--solver", action="store_true",
                        help="the solver's alone; and look whether docs/MUTANTS.md is up to date")
    parser.add_argument("--build", default=str(ROOT / "build" / "dev" / "tests" / "mutants"),
                        help="where the programs are")
    options = parser.parse_args()
    solver, renderer = table("solver.toml"), table("render.toml")
    if options.numbers:
        solver = [m for m in solver if m["number"] in options.numbers]
        renderer = [m for m in renderer if m["number"] in options.numbers]
    if options.solver:
        renderer = []
    build, solver_rows, renderer_rows = pathlib.Path(options.build), [], []
    unnoticed = try_solver(build / "sim_mutated", solver, solver_rows) if solver else 0
    unnoticed += try_renderer(build / "render_mutated", renderer, renderer_rows) if renderer else 0
    if options.docs:
        write_docs(solver_rows, renderer_rows)
    elif options.solver and check_docs(table("solver.toml") + table("render.toml")):
        return 1
    print(f"{len(solver) + len(renderer)} faults, {unnoticed} unnoticed")
    return 1 if unnoticed else 0


if __name__ == "__main__":
    sys.exit(main())
