#!/usr/bin/env python3
"""Plants faults: writes copies of sources in which each of the faults of a table is switched on by
its number, the variable `ember_mutant`.

    plant.py TABLE --list          names of the sources that have to be compiled from a copy
    plant.py TABLE --into FOLDER   writes these copies, and those of the headers among them; for a
                                   fault in a shader the file shaders/NUMBER/NAME; and a list of
                                   all, mutants.txt

A table is a TOML file of [[mutant]]s:
    number   its number, the only one of that number
    file     source or header, from the root of the repository
    old      the text to be replaced, which must be there exactly once
    within   a longer text, there exactly once, when `old` alone is not
    new      what stands there instead: an expression for an expression, and for a statement, which
             ends with a semicolon, other statements or none
    fault    what is wrong then, in one sentence
    tests    GoogleTest filter of the tests that have to notice
    says     regular expression that their failures must contain (may be left out)
"""
import argparse
import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
CODE = (".cpp", ".h")


def fail(table, mutant, reason):
    sys.exit(f"{table}: mutant {mutant['number']} in {mutant['file']}: {reason}; "
             "the source has changed, so the fault has to be planted anew")


def read_table(path):
    """The mutants of a table, each with the place [first, last) of its old text in its file."""
    mutants = tomllib.loads(pathlib.Path(path).read_text())["mutant"]
    seen = set()
    for m in mutants:
        if m["number"] in seen:
            fail(path, m, "its number is taken")
        seen.add(m["number"])
        text = (ROOT / m["file"]).read_text()
        around = m.get("within", m["old"])
        for whole, part in ((text, around), (around, m["old"])):
            if whole.count(part) != 1:
                fail(path, m, f"\"{part}\" is there {whole.count(part)} times")
        first = text.index(around) + around.index(m["old"])
        m["place"] = (first, first + len(m["old"]))
    return mutants


def switched(m):
    """Text that is the fault when its number is chosen."""
    if m["old"].rstrip().endswith(";"):
        return f"if (ember_mutant == {m['number']}) {{ {m['new']} }} else {{ {m['old']} }}"
    return f"(ember_mutant == {m['number']} ? ({m['new']}) : ({m['old']}))"


def planted(name, mutants):
    """The text of source `name` with all of its faults, last first, so places stay valid."""
    text = (ROOT / name).read_text()
    last = len(text)
    for m in sorted(mutants, key=lambda m: m["place"], reverse=True):
        if m["place"][1] > last:
            fail("table", m, "it overlaps with another one")
        last = m["place"][0]
        text = text[:m["place"][0]] + switched(m) + text[m["place"][1]:]
    return f"extern int ember_mutant;\n#line 1 \"{ROOT / name}\"\n{text}"


def including(headers):
    """The `headers`, and files of their folders that include one of them, directly or not."""
    found = set(headers)
    folders = {pathlib.Path(h).parts[0] for h in headers}
    files = [p for f in folders for p in sorted((ROOT / f).rglob("*")) if p.suffix in CODE]
    includes = {str(p.relative_to(ROOT)): re.findall(r'#include "([^"]+)"', p.read_text())
                for p in files}
    grown = True
    while grown:
        more = {name for name, of in includes.items() if found.intersection(of)} - found
        grown = bool(more)
        found |= more
    return found


def copies(mutants):
    """Name of every file that needs a copy, with its mutants."""
    code = [m for m in mutants if m["file"].endswith(CODE)]
    names = {m["file"] for m in code}
    names |= including({name for name in names if name.endswith(".h")})
    return {name: [m for m in code if m["file"] == name] for name in sorted(names)}


def replaced(m):
    """The text of a mutant's file with the fault."""
    text = (ROOT / m["file"]).read_text()
    return text[:m["place"][0]] + m["new"] + text[m["place"][1]:]


def write(file, text):
    """Leaves a file that is already as wanted alone."""
    if file.exists() and file.read_text() == text:
        return
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("table")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--list", action="store_true")
    what.add_argument("--into", type=pathlib.Path)
    options = parser.parse_args()
    mutants = read_table(options.table)
    files = copies(mutants)
    if options.list:
        print(";".join(files), end="")
        return
    for name, of in files.items():
        write(options.into / name, planted(name, of))
    for m in mutants:
        if not m["file"].endswith(CODE):
            folder = options.into / "shaders" / str(m["number"])
            write(folder / pathlib.Path(m["file"]).name, replaced(m))
    write(options.into / "mutants.txt", "".join(f"{m['number']} {m['fault']}\n" for m in mutants))


if __name__ == "__main__":
    main()
