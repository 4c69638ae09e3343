# SPDX-License-Identifier: GPL-3.0-or-later
"""What makes an adapter of a function that runs cases in an engine: the results and the command line.

What an engine has no words for raises NotRun, what it fails at EngineFailed: both are notes in the results, and the
other cases go on.
"""

import argparse
import contextlib
import csv
import datetime
import errno
import functools
import io
import math
import os
import re
import secrets
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
from typing import Callable, Dict, List, NamedTuple, Optional, Sequence

from case import MOST_STEPS, BadCase, Case, NotRun, read_cases
from outcome import EngineFailed, Run

COLUMNS = "case,steps,body,x,y,z,vx,vy,vz,wx,wy,wz,contact_time,max_overlap,note".split(",")
TIME_LIMIT = 600  # [s] of one call of an engine; a case takes a second, or ten where others keep the machine busy


class Failed(Exception):
    """The engine is not there at all, or the results cannot be written: one line."""


# --- Signals ---------------------------------------------------------------------------------------------------------
class Stopped(BaseException):
    """By a signal: on the way out engines are ended and folders removed. Only the first one counts."""

    def __init__(self, number: int):
        self.number = number


class Stops:
    """Signals that end a program, as exceptions."""

    def __init__(self):
        self.numbers = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
        self.came, self.held, self.deaf = None, False, False

    def begin(self) -> None:
        self.came, self.deaf = None, False
        for number in self.numbers:
            if signal.getsignal(number) is not signal.SIG_IGN:  # as nohup asks
                signal.signal(number, self.take)

    def take(self, number: int, _) -> None:
        if self.deaf:
            return
        self.came = number
        self.end()
        if not self.held:
            raise Stopped(number)

    def end(self) -> None:
        """Deaf from here to the program's end, which a second signal would give another exit code. Blocked, as Python
        complains of one that came just before it was to be ignored."""
        self.deaf = True
        if hasattr(signal, "pthread_sigmask"):
            signal.pthread_sigmask(signal.SIG_BLOCK, self.numbers)

    @contextlib.contextmanager
    def hold(self):
        """What comes meanwhile counts at the end."""
        self.held = True
        try:
            yield
        finally:
            self.held = False
        if self.came:
            raise Stopped(self.came)


stops = Stops()


@contextlib.contextmanager
def scratch():
    """All that is temporary, the engines' own too, is in one folder, and nothing of it stays, however this ends. The
    program's last act: no signal is taken after it."""
    folder = os.path.join(tempfile.gettempdir(), f"conformance-{secrets.token_hex(8)}")
    before, tempfile.tempdir = tempfile.tempdir, folder
    stops.begin()
    try:
        try:
            os.mkdir(folder, 0o700)
            yield
        finally:
            stops.end()
    finally:  # also after a signal on the way to the line before
        tempfile.tempdir = before
        shutil.rmtree(folder, ignore_errors=True)


# --- The engine ------------------------------------------------------------------------------------------------------
def run_engine(arguments: Sequence[str], folder: str, typed: str = "", **environment: str) -> str:
    """Runs the engine in the folder, types to it and gives what it said; EngineFailed with its last words."""
    quiet = {"OMPI_MCA_ess_singleton_isolated": "1", "OMP_NUM_THREADS": "1", "TMPDIR": tempfile.gettempdir()}
    process = None
    try:
        with stops.hold():  # else one that is about to start would be left to itself
            process = subprocess.Popen(arguments, cwd=folder, env={**os.environ, **quiet, **environment},
                                       stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                       start_new_session=True)
        said = process.communicate(typed.encode(), TIME_LIMIT)[0].decode("utf-8", "replace")
    except subprocess.TimeoutExpired as late:
        raise EngineFailed(f"did not end within {TIME_LIMIT} s") from late
    except OSError as error:
        raise EngineFailed(f"{arguments[0]}: {error.strerror}") from error
    finally:
        if process and process.poll() is None:
            end(process)
    if process.returncode != 0:
        words = last_words(said).replace(os.path.join(folder, ""), "")
        raise EngineFailed(words or f"ended with code {process.returncode}")
    return said


def end(process: subprocess.Popen) -> None:
    """With all that it started."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL) if hasattr(os, "killpg") else process.kill()
    process.wait()


def last_words(said: str) -> str:
    """The last line with an error in it, or the last one at all."""
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    errors = [line for line in lines if "error" in line.lower()]
    return (errors or lines or [""])[-1]


def version_by(pattern: str, *arguments: str, typed: str = "") -> Callable[[str], str]:
    """Engine.version: what the pattern's group finds in what the program says to these arguments."""

    @functools.lru_cache(maxsize=None)
    def version(program: str) -> str:
        found = re.search(pattern, run_engine([program, *arguments], tempfile.gettempdir(), typed))
        if not found:
            raise EngineFailed(f"{' '.join([program, *arguments])}: does not say which version it is")
        return found[1]

    return version


# --- Results ---------------------------------------------------------------------------------------------------------
def rows_of(case: Case, runs: Sequence[Run]) -> List[List[str]]:
    def text(number: Optional[float]) -> str:
        return "" if number is None or not math.isfinite(number) else repr(float(number))

    return [[case.name, str(run.steps), str(i + 1), *(text(x) for part in body for x in part),
             text(run.contact_time), text(run.max_overlap), run.note]
            for run in runs for i, body in enumerate(run.bodies)]


def note_of(case: Case, why: Exception) -> List[List[str]]:
    failed = "failed: " if isinstance(why, EngineFailed) else ""
    return [[case.name] + [""] * (len(COLUMNS) - 2) + [failed + one_line(str(why))]]


def one_line(text: str) -> str:
    """Without what a terminal would obey."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in " ".join(text.split()))


def results_text(about: Dict[str, str], rows: Sequence[Sequence[str]]) -> str:
    text = io.StringIO()
    for key, value in about.items():
        text.write(f"# {key}: {value}\n")
    csv.writer(text, lineterminator="\n").writerows([COLUMNS, *rows])
    return text.getvalue()


def write(path: str, text: str) -> None:
    """The whole file or none; "-" is standard output. UTF-8, whatever the locale is."""
    data = text.encode("utf-8", "backslashreplace")
    try:
        if path == "-":
            write_all(1, data)
        elif os.path.exists(path) and not os.path.isfile(path):  # a device, a pipe
            with open(path, "wb") as out:
                out.write(data)
        else:
            replace(os.path.realpath(path), data)
    except OSError as error:
        raise Failed(f"{'standard output' if path == '-' else path}: cannot write: {error.strerror}") from error


def write_all(file: int, data: bytes) -> None:
    while data:
        data = data[os.write(file, data):]


def replace(path: str, data: bytes) -> None:
    """A file keeps its rights, and is not replaced where it may not be written."""
    if os.path.exists(path) and not os.access(path, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    temporary = os.path.join(os.path.dirname(path), f".results-{secrets.token_hex(8)}")
    try:
        with open(temporary, "xb") as out:
            out.write(data)
            out.flush()
            os.fsync(out.fileno())
        if os.path.exists(path):
            os.chmod(temporary, stat.S_IMODE(os.stat(path).st_mode))
        os.replace(temporary, path)
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(temporary)


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
                with tempfile.TemporaryDirectory(prefix="case-") as folder:
                    runs = run_case(program, case, folder)
                yield case, runs
            except (NotRun, EngineFailed) as why:
                yield case, why

    return run


class Options(argparse.ArgumentParser):
    """Says what is wrong in one line, without the usage before it."""

    def error(self, message: str):
        raise BadCase(message)

    def print_help(self, file=None):
        write("-", self.format_help())


def options_of(engine: Engine, arguments: Optional[Sequence[str]]) -> argparse.Namespace:
    def steps(text: str) -> List[int]:
        words = text.split(",")
        numbers = [int(word) if re.fullmatch("[0-9]{1,9}", word) else 0 for word in words]
        if not all(1 <= n <= MOST_STEPS for n in numbers) or len(set(numbers)) < len(numbers):
            raise argparse.ArgumentTypeError(f"{text}: must be whole numbers from 1 to {MOST_STEPS} that differ")
        return numbers

    parser = Options(description=f"Runs cases of the conformance kit in {engine.name}.", allow_abbrev=False)
    parser.add_argument("cases", metavar="CASES_DIR", help="folder that verify conformance --cases wrote")
    parser.add_argument("-o", dest="results", metavar="RESULTS.csv", required=True, help="- is standard output")
    parser.add_argument("--program", default=engine.program, help="the engine's program (default: %(default)s)")
    parser.add_argument("--only", nargs="+", default=[], metavar="CASE", help="these cases alone")
    parser.add_argument("--steps", type=steps, metavar="N,N,...", help="in the time scale, in place of each case's own")
    return parser.parse_args(arguments)


def collect(engine: Engine, program: str, cases: Sequence[Case]) -> List[List[str]]:
    """The rows of the results, in the order of the cases."""
    rows = {}
    for case, outcome in engine.run(program, cases):
        rows[case.name] = note_of(case, outcome) if isinstance(outcome, Exception) else rows_of(case, outcome)
        if sys.stderr and sys.stderr.isatty():
            say(f"{case.name}: {outcome if isinstance(outcome, Exception) else 'ran'}")
    return [row for case in cases for row in rows[case.name]]


def check_results(results: str, cases: str) -> None:
    """Before anything runs, so that nothing runs in vain and no case is lost."""
    if results == "-":
        return
    folder = os.path.dirname(os.path.realpath(results))
    if not results or os.path.isdir(results):
        raise BadCase(f"-o {results}: must be a file")
    if not os.path.isdir(folder):
        raise BadCase(f"-o {results}: there is no such folder")
    if folder == os.path.realpath(cases) and os.path.realpath(results).endswith(".json"):
        raise BadCase(f"-o {results}: must not be one of the cases")


def adapt(engine: Engine, arguments: Optional[Sequence[str]]) -> None:
    options = options_of(engine, arguments)
    check_results(options.results, options.cases)
    cases = read_cases(options.cases, options.only)
    if options.steps:
        cases = [case._replace(steps=options.steps) for case in cases]
    program = shutil.which(options.program)
    if not program:
        raise Failed(f"--program {options.program}: there is no such program")
    program = os.path.abspath(program)
    about = {"engine": engine.name, "version": engine.version(program),
             "date": datetime.datetime.now(datetime.timezone.utc).date().isoformat(),
             "by": f"engines/conformance/{os.path.basename(sys.argv[0])}"}
    write(options.results, results_text(about, collect(engine, program, cases)))


def say(message: str) -> None:
    if sys.stderr:
        print(one_line(message), file=sys.stderr)


def main(engine: Engine, arguments: Optional[Sequence[str]] = None) -> int:
    """Exit codes: 0 done, 2 bad input, 4 the engine is not there or the results could not be written, 128 + n stopped
    by the signal n."""
    try:
        with scratch():
            adapt(engine, arguments)
        return 0
    except BadCase as error:
        code, why = 2, str(error)
    except (Failed, EngineFailed) as error:
        code, why = 4, str(error)
    except OSError as error:
        code, why = 4, f"{error.filename or tempfile.gettempdir()}: {error.strerror}"
    except Stopped as stopped:
        return 128 + stopped.number
    say(f"{os.path.basename(sys.argv[0])}: error: {why}")
    return code
