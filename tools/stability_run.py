"""One run of ./run stability: what lmp was told, what came out, and which of the kinds of outcome that is.

stable    it ran and is right within the stated bounds
warned    it ran, is not right within them, and a warning had said so
refused   not started, with the package's reason
stopped   stopped in its course, with the package's reason
FAULT     anything else: a number that is none, a hang, a crash, somebody else's error, wrong and silent
"""
import dataclasses
import hashlib
import json
import math
import pathlib
import re
import subprocess
import tempfile
import threading
import time

from benchlib import lmp, root

SCENES = root / "examples" / "extreme"
KINDS = ["stable", "warned", "refused", "stopped", "FAULT"]
OURS = re.compile(r"lb/ibb|gran/lsd/coulomb")
NOT_A_NUMBER = re.compile(r"(?<![\w.])[-+]?(nan|inf)(?![\w])", re.I)


@dataclasses.dataclass
class Case:
    """check(values, files) says what is wrong, or nothing; want: kind, or kind and a piece of the message"""
    group: str
    script: str
    variables: dict
    check: object = None
    want: str = ""         # of a row: "refused: piece", "stopped: piece", "stable", "warns: piece"
    title: str = ""        # of a row
    ranks: int = 1
    limit: float = 120.0   # seconds
    like: object = None    # another case whose values must be the same ...
    only: tuple = ()       # ... but only these, if not all

    @property
    def name(self):
        words = " ".join(f"{k}={v}" for k, v in self.variables.items())
        return f"{self.group}: {self.title}{' ' if self.title else ''}[{words}]" + (
            f" on {self.ranks} ranks" if self.ranks > 1 else "")

    def command(self):
        quoted = lambda v: f'"{v}"' if " " in str(v) else str(v)
        words = " ".join(f"-var {k} {quoted(v)}" for k, v in self.variables.items())
        np = f"-np {self.ranks} " if self.ranks > 1 else ""
        return f"./run {np}examples/extreme/{self.script} {words}"


@dataclasses.dataclass
class Result:
    kind: str
    why: str
    seconds: float
    values: dict


def numbers(text):
    """of the line "result name value ..."."""
    line = re.findall(r"^result (.*)", text, re.M)
    words = line[-1].split() if line else []
    try:
        return {name: float(value) for name, value in zip(words[::2], words[1::2])}
    except ValueError:
        return {}


def nan_in(text):
    """first line of output with a number that is none; messages may name one"""
    for line in text.splitlines():
        if NOT_A_NUMBER.search(line) and not re.search(r"ERROR|WARNING|Fix lb/ibb|variable |^Last", line):
            return line.strip()
    return ""


def last_dump(files):
    """last step that a dump of every step holds as a whole, if there is one"""
    if "atoms.dump" not in files:
        return math.inf
    steps = re.findall(r"^ITEM: TIMESTEP\n(\d+)\n.*\n(\d+)\n(?:.*\n){4}ITEM: ATOMS.*\n((?:\d.*\n)*)", files["atoms.dump"],
                       re.M)
    return max((int(step) for step, atoms, lines in steps if lines.count("\n") == int(atoms)), default=-1)


def steps_done(text):
    """whether a line of thermo output has a step beyond 0"""
    return bool(re.search(r"^ +[1-9]\d* +\S+", text.split("Step")[-1], re.M)) if "Step" in text else False


class Store:
    """what has been run, by command, scripts and lmp; safe to stop at any moment"""

    def __init__(self, folder):
        self.file, self.done, self.lock = folder / "runs.jsonl", {}, threading.Lock()
        self.lmp = hashlib.sha256(pathlib.Path(lmp).read_bytes()).hexdigest()
        if self.file.exists():
            for line in self.file.read_text().splitlines():
                try:
                    self.done.update([json.loads(line)])
                except ValueError:    # cut off when it was stopped
                    pass

    def raw(self, case):
        script = (SCENES / case.script).read_text()
        key = hashlib.sha256("\0".join([self.lmp, script, *words(case), str(case.limit)]).encode()).hexdigest()
        with self.lock:
            if key in self.done:
                return self.done[key]
        run = launch(case)
        with self.lock:
            self.done[key] = run
            with open(self.file, "a") as file:
                file.write(json.dumps([key, run]) + "\n")
        return run

    def result(self, case):
        run = self.raw(case)
        kind, why = judge(case, run)
        if case.like is not None and kind in ("stable", "warned"):
            mine, other = numbers(run["text"]), numbers(self.raw(case.like)["text"])
            for name in case.only or other:
                size = max(abs(other[name]), 1e-30)
                if abs(mine[name] - other[name]) > 1e-9 * size:
                    kind, why = "FAULT", f"{name} is {mine[name]}, but {other[name]} in {case.like.name}"
        return Result(kind, why, run["seconds"], numbers(run["text"]))


def words(case):
    options = [w for name, value in case.variables.items() for w in ("-var", name, str(value))]
    start = ["mpirun", "-np", str(case.ranks)] if case.ranks > 1 else []
    return [*start, lmp, "-in", str(SCENES / case.script), "-log", "none", "-nocite", *options]


def launch(case):
    begin, rc = time.time(), None
    with tempfile.TemporaryDirectory() as folder:
        try:
            done = subprocess.run(words(case), cwd=folder, capture_output=True, text=True, timeout=case.limit,
                                  errors="replace", stdin=subprocess.DEVNULL)
            rc, text = done.returncode, done.stdout + done.stderr
        except subprocess.TimeoutExpired as late:
            text = (late.stdout or b"").decode(errors="replace")
        files = {p.name: p.read_text(errors="replace") for p in sorted(pathlib.Path(folder).iterdir()) if p.is_file()}
    return {"rc": rc, "text": text, "files": files, "seconds": time.time() - begin}


def plain(message):
    """without where in the source it comes from"""
    return re.sub(r"^ERROR:? ?(on proc \d+)?:? *| \([^ ()]+:\d+\)$", "", message)


def outcome(case, run):
    """kind and reason, whatever was wanted"""
    rc, text = run["rc"], run["text"]
    if rc is None:
        return "FAULT", f"hangs: not done after {case.limit:.0f} s"
    for name, output in [("output", text), *run["files"].items()]:
        if nan_in(output):
            return "FAULT", f"not a number in {name}: {nan_in(output)[:120]}"
    error = re.findall(r"^.*ERROR.*", text, re.M)
    if rc != 0:
        if not error or rc < 0 or rc > 128:
            return "FAULT", f"crash, exit status {rc}: {text[-200:]}"
        if not OURS.search(error[0]):
            return "FAULT", "stopped by a message that is not the package's: " + error[0]
        stop = re.search(r"stopped at step (\d+)", error[0])
        if stop and last_dump(run["files"]) < int(stop.group(1)) - 1:
            return "FAULT", f"dump ends at step {last_dump(run['files'])}, before: {error[0]}"
        reason = plain(error[0])
        return ("stopped" if "stopped at step" in reason or steps_done(text) else "refused"), reason
    if error:
        return "FAULT", "exit status 0 with " + error[0]
    values = numbers(text)
    if not values:
        return "FAULT", "no result at the end"
    wrong = case.check(values, run["files"], case.variables) if case.check else ""
    if not wrong:
        return "stable", ""
    warnings = [w for w in re.findall(r"^WARNING: (.*)", text, re.M) if OURS.search(w)]
    return ("warned", f"{wrong}; {plain(warnings[0])}") if warnings else ("FAULT", "wrong and silent: " + wrong)


def judge(case, run):
    kind, why = outcome(case, run)
    if not case.want or kind == "FAULT":
        return kind, why
    wanted, _, piece = case.want.partition(": ")
    if wanted == "warns":
        if kind in ("refused", "stopped"):
            return "FAULT", f"wanted a warning, not: {why}"
        warning = [w for w in re.findall(r"^WARNING: (.*)", run["text"], re.M) if piece in w]
        return (kind, "warning: " + plain(warning[0])) if warning else ("FAULT", f"no warning with '{piece}'")
    if kind != wanted and not (wanted == "stable" and kind == "warned"):
        return "FAULT", f"wanted {case.want}, found {kind} {why}"
    return (kind, why) if piece in why else ("FAULT", f"no '{piece}' in: {why}")
