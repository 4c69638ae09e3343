"""The command line of every adapter: results, exit codes, and what is left however it ends."""

import csv
import math
import os
import signal
import stat
import subprocess
import sys
import time

import pytest
from pair_case import ADAPTERS, kit, written

import adapter
import outcome


@pytest.fixture(autouse=True)
def signals_as_before(monkeypatch):
    """An adapter is deaf once it has ended; what runs it here is not to be."""
    monkeypatch.setattr(adapter, "stops", adapter.Stops())
    numbers = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]
    before = [signal.getsignal(number) for number in numbers]
    yield
    for number, handler in zip(numbers, before):
        signal.signal(number, handler)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, numbers)


def engine(run, version="1.2"):
    return adapter.Engine("Toy", "python3", lambda program: version, adapter.one_by_one(run))


def umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask


def last_line_of(capfd):
    """What a user sees: one line that begins with the program's name, which is left out."""
    said = capfd.readouterr().err
    assert said.count("\n") == 1
    program, message = said.rstrip("\n").split(": error: ")
    assert program == os.path.basename(sys.argv[0])
    return message


def still(program, case, folder):
    """The bodies stay where they start; the case `odd` has no words, `ill` ends badly."""
    if case.name == "odd":
        raise kit.NotRun("no words for it")
    if case.name == "ill":
        script = f"echo 'ERROR: {folder}/deck: schlecht, tatsächlich'; echo bye; exit 3"
        adapter.run_engine(["/bin/sh", "-c", script], folder)
    return [outcome.Run(n, [outcome.State(b.position, b.velocity, b.spin) for b in case.bodies], 1e-4, None)
            for n in case.steps]


def test_results_are_rows_and_notes(tmp_path):
    for name in ("odd", "ill", "pair"):
        written(tmp_path, case=name)
    result = tmp_path / "toy.csv"
    assert adapter.main(engine(still), [str(tmp_path), "-o", str(result), "--steps", "50"]) == 0
    lines = result.read_text(encoding="utf-8").splitlines()
    assert lines[:2] == ["# engine: Toy", "# version: 1.2"]
    assert lines[2].startswith("# date: 20") and lines[3].startswith("# by: engines/conformance/")
    assert lines[4] == "case,steps,body,x,y,z,vx,vy,vz,wx,wy,wz,contact_time,max_overlap,note"
    assert lines[5] == 'ill' + "," * 14 + '"failed: ERROR: deck: schlecht, tatsächlich"'
    assert lines[6] == "odd" + "," * 14 + "no words for it"
    assert lines[7] == "pair,50,1,-0.0015,0.0,0.0,0.25,0.0,0.0,0.0,0.0,0.0,0.0001,,"
    assert lines[8] == "pair,50,2,0.0015,0.0,0.0,-0.25,0.0,0.0,0.0,0.0,0.0,0.0001,,"
    assert len(lines) == 9
    assert stat.S_IMODE(result.stat().st_mode) == 0o666 & ~umask()


def test_results_appear_whole_or_not_at_all(tmp_path, monkeypatch, capfd):
    written(tmp_path)
    result = tmp_path / "toy.csv"
    result.write_text("before")

    def full(*_):
        raise OSError(28, "No space left on device")

    for step in ("replace", "fsync"):
        with monkeypatch.context() as patch:
            patch.setattr(os, step, full)
            assert adapter.main(engine(still), [str(tmp_path), "-o", str(result)]) == 4
        assert last_line_of(capfd) == f"{result}: cannot write: No space left on device"
        assert result.read_text() == "before" and sorted(os.listdir(tmp_path)) == ["pair.json", "toy.csv"]


def test_a_file_that_is_replaced_keeps_its_rights_and_a_link_leads_to_it(tmp_path, monkeypatch, capfd):
    written(tmp_path)
    result, link = tmp_path / "toy.csv", tmp_path / "link.csv"
    result.write_text("before")
    result.chmod(0o640)
    link.symlink_to(result)
    assert adapter.main(engine(still), [str(tmp_path), "-o", str(link)]) == 0
    assert link.is_symlink() and result.read_text().startswith("# engine: Toy\n")
    assert stat.S_IMODE(result.stat().st_mode) == 0o640

    access = os.access
    monkeypatch.setattr(os, "access", lambda path, mode: mode != os.W_OK and access(path, mode))  # as for all but root
    assert adapter.main(engine(still), [str(tmp_path), "-o", str(result)]) == 4
    assert last_line_of(capfd) == f"{result}: cannot write: Permission denied"


def test_a_pipe_is_written_to_and_stays_one(tmp_path):
    written(tmp_path)
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE, text=True) as reader:
        assert adapter.main(engine(still), [str(tmp_path), "-o", str(pipe)]) == 0
        assert reader.communicate(timeout=20)[0].startswith("# engine: Toy\n")
    assert stat.S_ISFIFO(pipe.stat().st_mode)


@pytest.mark.parametrize("code, message, words", [
    (2, "--only none: must be one of pair", "-o - --only none"),
    (4, "--program no-such-engine: there is no such program", "-o - --program no-such-engine"),
    (2, "-o {0}/absent/x.csv: there is no such folder", "-o {0}/absent/x.csv"),
    (2, "-o {0}/pair.json: must not be one of the cases", "-o {0}/pair.json"),
    (2, "-o {0}: must be a file", "-o {0}"),
    (2, "-o : must be a file", "-o="),
    (2, "the following arguments are required: -o", ""),
    (2, "unrecognized arguments: --what", "-o - --what"),
    (2, "argument --steps: 50,0: must be whole numbers from 1 to 10000000 that differ", "-o - --steps 50,0"),
    (2, "argument --steps: 50,50: must be whole numbers from 1 to 10000000 that differ", "-o - --steps 50,50"),
    (2, "argument --steps: 9" + 5000 * "9" + ": must be whole numbers from 1 to 10000000 that differ",
     "-o - --steps 9" + 5000 * "9"),
])
def test_what_is_wrong_is_told_in_one_line(tmp_path, capfd, code, message, words):
    written(tmp_path)
    case = (tmp_path / "pair.json").read_text()
    arguments = [word[:-1] if word == "-o=" else word for word in words.format(tmp_path).split()]
    assert adapter.main(engine(still), [str(tmp_path), *arguments, *([""] if words == "-o=" else [])]) == code
    assert last_line_of(capfd) == message.format(tmp_path)
    assert (tmp_path / "pair.json").read_text() == case and os.listdir(tmp_path) == ["pair.json"]


def test_no_name_reaches_the_terminal_as_a_command(tmp_path, capfd):
    folder = tmp_path / "red\x1b[31m\nfolder"
    assert adapter.main(engine(still), [str(folder), "-o", "-"]) == 2
    assert last_line_of(capfd) == f"{tmp_path}/red\\x1b[31m folder: is no folder"


def test_an_engine_without_a_version_is_none(tmp_path, capfd):
    written(tmp_path)
    mute = adapter.Engine("Toy", "true", adapter.version_by(r"version (\S+)", "-h"), adapter.one_by_one(still))
    assert adapter.main(mute, [str(tmp_path), "-o", "-"]) == 4
    assert last_line_of(capfd).endswith("/true -h: does not say which version it is")


# --- As programs of their own ----------------------------------------------------------------------------------------
SHOWN = [name for name in sorted(p.name for p in ADAPTERS.glob("*.py"))
         if os.access(ADAPTERS / name, os.X_OK)]


@pytest.mark.parametrize("name", SHOWN)
@pytest.mark.parametrize("locale", [
    {"LC_ALL": "C", "PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}])
def test_help_is_shown_in_any_locale(name, locale):
    ran = subprocess.run([sys.executable, ADAPTERS / name, "--help"], env={**os.environ, **locale}, capture_output=True)
    assert ran.returncode == 0 and ran.stderr == b"" and ran.stdout.startswith(f"usage: {name} ".encode())
    with open("/dev/full", "w") as full:
        ran = subprocess.run([sys.executable, ADAPTERS / name, "--help"], stdout=full, stderr=subprocess.PIPE)
    assert ran.returncode == 4
    assert ran.stderr.decode() == f"{name}: error: standard output: cannot write: No space left on device\n"


def test_all_adapters_are_shown():
    assert SHOWN == ["lammps.py", "liggghts.py", "simulate.py", "template.py", "yade.py"]


def test_wrong_cases_leave_no_traceback(tmp_path):
    for text in ("[" * 100_000, '{"schema": 1' + 400 * "0" + "}", '{"schema": 1' + 5000 * "0" + "}"):
        (tmp_path / "ill.json").write_text(text)
        ran = subprocess.run([sys.executable, ADAPTERS / "template.py", tmp_path, "-o", "-"], capture_output=True,
                             text=True)
        assert ran.returncode == 2 and ran.stdout == ""
        assert ran.stderr.startswith(f"template.py: error: {tmp_path}/ill.json: ") and ran.stderr.count("\n") == 1


def started(tmp_path, program, hang_up=signal.SIG_DFL):
    """The template at work, its engine the given program, its temporary files in a folder of their own. What it does at
    signals is not left to whoever runs the tests: a shell's background jobs ignore SIGINT."""
    def as_in_a_terminal():
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.signal(signal.SIGHUP, hang_up)

    (tmp_path / "cases").mkdir(exist_ok=True)
    (tmp_path / "tmp").mkdir(exist_ok=True)
    written(tmp_path / "cases", steps=[25, 50, 100, 200])
    return subprocess.Popen([sys.executable, ADAPTERS / "template.py", tmp_path / "cases", "-o",
                             tmp_path / "mine.csv", "--program", program],
                            env={**os.environ, "TMPDIR": str(tmp_path / "tmp")}, stderr=subprocess.PIPE,
                            preexec_fn=as_in_a_terminal)


def wait_for(condition):
    end = time.monotonic() + 30
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


def alive(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_ends_the_engine_and_leaves_nothing(tmp_path, number):
    slow = tmp_path / "slow"
    slow.write_text(f"""#!/bin/sh
[ "$1" = --version ] && {{ echo Python 1.2; exit; }}
touch "$TMPDIR/left"
sleep 300 &
echo $! >{tmp_path}/pid
wait
""")
    slow.chmod(0o755)
    with started(tmp_path, slow) as adapted:
        wait_for(lambda: (tmp_path / "pid").exists() and (tmp_path / "pid").read_text().endswith("\n"))
        end = time.monotonic() + 20
        while adapted.poll() is None and time.monotonic() < end:  # until it is gone
            adapted.send_signal(number)
        assert adapted.poll() == 128 + number
        assert adapted.stderr.read() == b""
    wait_for(lambda: not alive(int((tmp_path / "pid").read_text())))
    assert os.listdir(tmp_path / "tmp") == [] and not (tmp_path / "mine.csv").exists()


def test_an_engine_that_is_just_starting_ends_too(tmp_path, monkeypatch):
    begun, popen = [], subprocess.Popen

    def start(*arguments, **keys):
        begun.append(popen(*arguments, **keys))
        os.kill(os.getpid(), signal.SIGTERM)
        return begun[0]

    monkeypatch.setattr(subprocess, "Popen", start)
    with pytest.raises(adapter.Stopped), adapter.scratch():
        adapter.run_engine(["/bin/sleep", "300"], str(tmp_path))
    assert begun[0].poll() == -signal.SIGKILL


def undated(results):
    """It may be midnight."""
    return [line for line in results.read_text().splitlines() if not line.startswith("# date: ")]


def test_a_signal_at_any_time_leaves_nothing_or_all(tmp_path):
    begun = time.monotonic()
    with started(tmp_path, sys.executable) as adapted:
        assert adapted.wait() == 0
    lasted = time.monotonic() - begun
    assert os.listdir(tmp_path / "tmp") == []
    whole = undated(tmp_path / "mine.csv")
    for share in (0.1, 0.4, 0.7, 0.9, 1.0):
        (tmp_path / "mine.csv").unlink(missing_ok=True)
        with started(tmp_path, sys.executable) as adapted:
            time.sleep(share * lasted)
            adapted.terminate()
            code = adapted.wait(20)
        assert code in (0, 128 + signal.SIGTERM, -signal.SIGTERM)  # the last: it is no adapter yet
        assert os.listdir(tmp_path / "tmp") == []
        left = [name for name in sorted(os.listdir(tmp_path)) if name not in ("cases", "tmp")]
        assert left == [] or (left == ["mine.csv"] and undated(tmp_path / "mine.csv") == whole)


def test_nohup_is_obeyed(tmp_path):
    signal_to_itself = tmp_path / "hangs_up"
    signal_to_itself.write_text(f"#!/bin/sh\nkill -HUP $PPID\nexec {sys.executable} \"$@\"\n")
    signal_to_itself.chmod(0o755)
    with started(tmp_path, signal_to_itself) as adapted:
        assert adapted.wait() == 128 + signal.SIGHUP
    with started(tmp_path, signal_to_itself, hang_up=signal.SIG_IGN) as adapted:
        assert adapted.wait() == 0


# --- The engine ------------------------------------------------------------------------------------------------------
def test_an_engine_that_hangs_is_stopped(tmp_path, monkeypatch):
    monkeypatch.setattr(adapter, "TIME_LIMIT", 0.2)
    with pytest.raises(outcome.EngineFailed, match="did not end within 0.2 s"):
        adapter.run_engine(["/bin/sleep", "5"], str(tmp_path))
    with pytest.raises(outcome.EngineFailed, match="/no-such-engine: No such file"):
        adapter.run_engine(["/no-such-engine"], str(tmp_path))


def test_what_an_engine_leaves_may_be_anything(tmp_path, capfd):
    """A note in the results, and the other cases go on."""
    cases = tmp_path / "cases"
    cases.mkdir()
    for name in ("absent", "garbled", "short", "right"):
        written(cases, case=name)

    def run(program, case, folder):
        left = {"garbled": "0 1 two\n", "short": "0 1\n", "right": "0 1 2\n"}
        path = os.path.join(folder, "path")
        if case.name in left:
            with open(path, "w", encoding="utf-8") as out:
                out.write(left[case.name])
        rows = [outcome.numbers_of(line.split(), 3) for line in outcome.lines_of(path)]
        return [outcome.Run(25, [outcome.State(rows[0], rows[0], rows[0])], math.nan)]

    assert adapter.main(engine(run), [str(cases), "-o", str(tmp_path / "toy.csv")]) == 0
    rows = list(csv.reader((tmp_path / "toy.csv").read_text().splitlines()[5:]))
    assert [(row[0], row[-1]) for row in rows] == [
        ("absent", "failed: path: No such file or directory"),
        ("garbled", "failed: wrote a line that is not of numbers: 0 1 two"),
        ("right", ""), ("short", "failed: wrote 2 numbers in a line, not 3")]
    assert rows[2][12] == ""  # a time that is no number is none


def test_last_words_are_the_last_error():
    assert adapter.last_words("start\nERROR: lost atoms\nlast\n\n") == "ERROR: lost atoms"
    assert adapter.last_words("start\nlast  \n \n") == "last" and adapter.last_words("") == ""
