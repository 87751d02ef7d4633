#!/usr/bin/python3
"""Runs the commands of a page as they are written, and compares what they print with what the page quotes.

Usage: scripts/run_page.py PAGE [--programs FOLDER] [--skip LINE]...

PAGE is a text of the manual or a Markdown file. Commands are the blocks \\code{.sh} or ```sh; they start in the folder of
the package, and each block in the folder where the one before ended. Lines of a block \\code{.unparsed} or ```text are
among those that the commands before it print, word by word; numbers differ by a twentieth at most. Behind an excerpt of an
example, they are among those that this program prints, which is run in FOLDER, and not compared without it. Commands that are
a LINE, but for a comment behind, are left out.
"""
import argparse
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^(?:\\dontinclude .*?(\w+)\.cpp|(?:\\code\{\.(\w+)\}|```(\w+))\n(.*?)\n(?:\\endcode|```))$",
                   re.DOTALL | re.MULTILINE)


def run(commands, folder):
    """What they print, and the folder where they end."""
    with tempfile.NamedTemporaryFile("r") as end:
        output = []
        with subprocess.Popen(["bash", "-e", "-c", f"{commands}\npwd > {shlex.quote(end.name)}"], cwd=folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
            for line in process.stdout:
                print(line, end="", flush=True)
                output.append(line.strip())
        if process.returncode != 0:
            sys.exit(f"FAILED, with status {process.returncode}:\n{commands}")
        return output, end.read().strip()


def is_same(quoted, printed):
    numbers = re.compile(r"\d+(?:\.\d+)?(?:e[+-]?\d+)?")
    return numbers.sub("#", quoted) == numbers.sub("#", printed) and all(
        abs(float(a) - float(b)) <= 0.05 * abs(float(a)) for a, b in zip(numbers.findall(quoted), numbers.findall(printed)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path)
    parser.add_argument("--programs", type=Path, metavar="FOLDER")
    parser.add_argument("--skip", action="append", default=[], metavar="LINE")
    arguments = parser.parse_args()
    folder, program, output, numbers, differences = ROOT, "", [], {"sh": 0, "unparsed": 0}, []
    for example, of_manual, of_markdown, text in BLOCK.findall(arguments.page.read_text()):
        kind = of_manual or of_markdown.replace("text", "unparsed")
        if example:
            program = example
            continue
        if program and kind == "unparsed":
            if not arguments.programs:
                continue
            output, _ = run(f"./{program}", arguments.programs)
        program = ""
        if kind == "sh":
            lines = [line for line in text.splitlines() if line.split(" #")[0].strip() not in arguments.skip]
            print("", *(f"$ {line}" for line in lines), sep="\n", flush=True)
            output, folder = run("\n".join(lines), folder)
        elif kind == "unparsed":
            differences += [f"quoted, but not printed: {line}" for line in text.splitlines()
                            if not any(is_same(line.strip(), printed) for printed in output)]
        numbers[kind] = numbers.get(kind, 0) + 1
    print(*differences, f"{arguments.page}: {numbers['sh']} blocks of commands ran, {numbers['unparsed']} were compared", sep="\n")
    sys.exit(1 if differences or not numbers["sh"] else 0)


if __name__ == "__main__":
    main()
