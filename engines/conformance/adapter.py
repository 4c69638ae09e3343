# SPDX-License-Identifier: GPL-3.0-or-later
"""What makes an adapter of a function that runs cases in an engine: the results and the command line.

What an engine has no words for raises NotRun, what it fails at EngineFailed: both are notes in the results, and the
other cases go on.
"""

import argparse
import csv
import datetime
import io
import os
import shutil
import subprocess
import sys
import tempfile
from typing import Callable, Dict, List, NamedTuple, Optional, Sequence

from case import BadCase, Case, NotRun, read_cases
from outcome import EngineFailed, Run

COLUMNS = "case,steps,body,x,y,z,vx,vy,vz,wx,wy,wz,contact_time,max_overlap,note".split(",")
TIME_LIMIT = 600  # [s] of one call of an engine; a case takes a second, or ten where others keep the machine busy


class NoEngine(Exception):
    """The engine is not there at all."""


# --- The engine ------------------------------------------------------------------------------------------------------
def run_engine(arguments: Sequence[str], folder: str, typed: str = "", **environment: str) -> str:
    """Runs the engine in the folder, types to it and gives what it said; EngineFailed with its last words."""
    quiet = {"OMPI_MCA_ess_singleton_isolated": "1", "OMP_NUM_THREADS": "1", **environment}
    try:
        ran = subprocess.run(arguments, cwd=folder, env={**os.environ, **quiet}, input=typed.encode(),
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired as late:
        raise EngineFailed(f"did not end within {TIME_LIMIT} s") from late
    except OSError as error:
        raise EngineFailed(f"{arguments[0]}: {error.strerror}") from error
    said = ran.stdout.decode("utf-8", "replace")
    if ran.returncode != 0:
        words = last_words(said).replace(os.path.join(folder, ""), "")
        raise EngineFailed(words or f"ended with code {ran.returncode}")
    return said


def last_words(said: str) -> str:
    """The last line with an error in it, or the last one at all."""
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    errors = [line for line in lines if "error" in line.lower()]
    return (errors or lines or [""])[-1]


# --- Results ---------------------------------------------------------------------------------------------------------
def rows_of(case: Case, runs: Sequence[Run]) -> List[List[str]]:
    def text(number: Optional[float]) -> str:
        return "" if number is None else repr(float(number))

    return [[case.name, str(run.steps), str(i + 1), *(text(x) for part in body for x in part),
             text(run.contact_time), text(run.max_overlap), run.note]
            for run in runs for i, body in enumerate(run.bodies)]


def note_of(case: Case, why: Exception) -> List[List[str]]:
    failed = "failed: " if isinstance(why, EngineFailed) else ""
    return [[case.name] + [""] * (len(COLUMNS) - 2) + [failed + " ".join(str(why).split())]]


def write_results(path: str, about: Dict[str, str], rows: Sequence[Sequence[str]]) -> None:
    """The whole file or none; "-" is standard output."""
    text = io.StringIO()
    for key, value in about.items():
        text.write(f"# {key}: {value}\n")
    csv.writer(text, lineterminator="\n").writerows([COLUMNS, *rows])
    if path == "-":
        sys.stdout.write(text.getvalue())
        return
    folder = os.path.dirname(os.path.abspath(path))
    handle, temporary = tempfile.mkstemp(dir=folder, prefix=".results-")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as out:
            out.write(text.getvalue())
        os.chmod(temporary, 0o666 & ~current_umask())
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def current_umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


# --- The command line of every adapter -------------------------------------------------------------------------------
class Engine(NamedTuple):
    """`version(program)` asks the engine itself; `run(program, cases)` yields a case and its runs, or a case and the
    NotRun or EngineFailed that it ended with."""

    name: str
    program: str
    version: Callable[[str], str]
    run: Callable


def one_by_one(run_case: Callable) -> Callable:
    """Engine.run of a function (program, case, folder) → runs, called with a new folder for each case."""

    def run(program: str, cases: Sequence[Case]):
        for case in cases:
            try:
                with tempfile.TemporaryDirectory(prefix="conformance-") as folder:
                    runs = run_case(program, case, folder)
                yield case, runs
            except (NotRun, EngineFailed) as why:
                yield case, why

    return run


def options_of(engine: Engine, arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    def steps(text: str) -> List[int]:
        numbers = [int(n) for n in text.split(",")]
        if min(numbers) < 1 or len(set(numbers)) < len(numbers):
            raise ValueError
        return numbers

    parser = argparse.ArgumentParser(description=f"Runs cases of the conformance kit in {engine.name}.")
    parser.add_argument("cases", metavar="CASES_DIR", help="folder that verify conformance --cases wrote")
    parser.add_argument("-o", dest="results", metavar="RESULTS.csv", required=True, help="- is standard output")
    parser.add_argument("--program", default=engine.program, help="the engine's program (default: %(default)s)")
    parser.add_argument("--only", nargs="+", default=[], metavar="CASE", help="these cases alone")
    parser.add_argument("--steps", type=steps, metavar="N,N,…", help="in the time scale, in place of each case's own")
    return parser.parse_args(arguments)


def collect(engine: Engine, program: str, cases: Sequence[Case]) -> List[List[str]]:
    """The rows of the results, in the order of the cases."""
    rows = {}
    for case, outcome in engine.run(program, cases):
        rows[case.name] = note_of(case, outcome) if isinstance(outcome, Exception) else rows_of(case, outcome)
        if sys.stderr.isatty():
            print(f"{case.name}: {outcome if isinstance(outcome, Exception) else 'ran'}", file=sys.stderr)
    return [row for case in cases for row in rows[case.name]]


def check_results(results: str, cases: str) -> None:
    """Before anything runs, so that nothing runs in vain and no case is lost."""
    if results == "-":
        return
    folder = os.path.dirname(os.path.realpath(results))
    if not os.path.isdir(folder):
        raise BadCase(f"-o {results}: there is no such folder")
    if os.path.isdir(results):
        raise BadCase(f"-o {results}: must be a file")
    if folder == os.path.realpath(cases) and results.endswith(".json"):
        raise BadCase(f"-o {results}: must not be one of the cases")


def main(engine: Engine, arguments: Optional[Sequence[str]] = None) -> int:
    """Exit codes: 0 done, 2 bad input, 4 the engine is not there or the results could not be written, 130 by Ctrl-C."""
    options = options_of(engine, arguments)
    try:
        check_results(options.results, options.cases)
        cases = read_cases(options.cases, options.only)
        if options.steps:
            cases = [case._replace(steps=options.steps) for case in cases]
        program = shutil.which(options.program)
        if not program:
            raise NoEngine(f"--program {options.program}: there is no such program")
        about = {"engine": engine.name, "version": engine.version(os.path.abspath(program)),
                 "date": datetime.datetime.now(datetime.timezone.utc).date().isoformat(),
                 "by": f"engines/conformance/{os.path.basename(sys.argv[0])}"}
        write_results(options.results, about, collect(engine, os.path.abspath(program), cases))
    except BadCase as error:
        print(error, file=sys.stderr)
        return 2
    except (NoEngine, EngineFailed) as error:
        print(f"{engine.name}: {error}", file=sys.stderr)
        return 4
    except OSError as error:
        print(f"{options.results}: {error.strerror}", file=sys.stderr)
        return 4
    except KeyboardInterrupt:
        return 130
    return 0
