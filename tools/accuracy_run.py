"""Runs of ./run accuracy: what lmp was told, what it cost, and what of it is kept between calls.

A point is one number against its reference, found from one run or several (places of a grain against the
lattice, a moving grain beside a fixed one). Seconds are LAMMPS's loop times, cpu the processor time of the whole
process: the first count on an idle machine only, the second are less sensitive.
"""
import dataclasses
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time

from benchlib import lmp, root

EXAMPLES = root / "examples"
RADII = root / "potentials" / "lbm-ibb.radius"
COLUMNS = ("case quantity sweep r_over_dx tau collision link refill average precision radius value reference error scatter "
           "wall_s cpu_s steps node_updates mlups memory_mib ranks load commit machine").split()
ALONE = ("bench/", "accuracy/in.lb_fluid", "accuracy/in.moving_array")    # on one rank
# what makes a row: another of the same replaces it
IDENTITY = COLUMNS[:COLUMNS.index("value")]
DEFAULT = {"collision": "trt", "link": "cli", "refill": "grad", "average": "yes", "precision": "double", "radius": "given"}


class Failed(Exception):
    """a run that did not end well, with the last it said"""


@dataclasses.dataclass
class Run:
    """one run of an input script below examples/, or of a program of the build"""
    script: str
    variables: dict
    ranks: int = 1
    files: tuple = ()          # that the script leaves and that are wanted
    limit: float = 900.0

    def words(self, folder):
        if self.script.startswith("bench/"):
            program = pathlib.Path(os.environ["LBMIBB_BUILD"]) / self.script
            return [str(program), *map(str, self.variables.values())]
        options = [w for name, value in self.variables.items() for w in ("-var", name, str(value))]
        start = ["mpirun", "-np", str(self.ranks)] if self.ranks > 1 else []
        name = pathlib.Path(self.script).name
        return [*start, lmp, "-in", str(folder / name), "-log", "none", "-nocite", *options]

    def command(self):
        quoted = lambda v: f'"{v}"' if " " in str(v) else str(v)
        options = " ".join(f"-var {k} {quoted(v)}" for k, v in self.variables.items())
        np = f"-np {self.ranks} " if self.ranks > 1 else ""
        return f"./run {np}examples/{self.script} {options}"


@dataclasses.dataclass
class Point:
    """evaluate(list of Done) gives dictionaries: quantity, value, reference, and if need be error, scatter"""
    case: str
    sweep: str                 # which choice is varied
    runs: list
    evaluate: object
    r: float                   # cells per radius, or per half width of a channel
    tau: float
    choice: dict = dataclasses.field(default_factory=dict)    # what is not the default
    updates: float = 1e7       # guess: for the progress line, and what is run first

    def __post_init__(self):    # two ranks where a run takes seconds
        if (os.cpu_count() or 1) > 1 and self.updates / len(self.runs) > 1e8:
            for run in self.runs:
                run.ranks = 1 if run.script.startswith(ALONE) else 2

    def importance(self):
        """0 first: the default, then what it does at other tau and with corrected radii, then the other rules"""
        return {"dx": 0, "steps_per_contact": 0, "tau": 1, "radius": 1, "place": 1}.get(self.sweep, 2)

    def name(self):
        other = " ".join(str(v) for v in self.choice.values())
        return f"{self.case} r {self.r:.3g} tau {self.tau:g}{' ' if other else ''}{other}"


@dataclasses.dataclass
class Done:
    text: str
    files: dict
    wall: float                # of LAMMPS's loops
    cpu: float
    steps: int
    nodes: int
    memory: float
    load: float


def words_after(text, name):
    """numbers of the last line "result name value ...", or of a line that begins with name"""
    line = re.findall(rf"^{name} (.*)", text, re.M)
    words = line[-1].split() if line else []
    return {a: float(b) for a, b in zip(words[::2], words[1::2])}


def commit():
    done = subprocess.run(["git", "-C", str(root), "describe", "--always", "--dirty", "--exclude", "*"],
                          capture_output=True, text=True)
    return done.stdout.strip() or "unknown"


def machine():
    try:
        return re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text()).group(1)
    except (OSError, AttributeError):
        return "unknown"


def launch(run):
    """in a copy of the script's folder, so that it finds and leaves its files there"""
    load = os.getloadavg()[0]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "run"
        if run.script.startswith("bench/"):
            folder.mkdir()
        else:
            shutil.copytree((EXAMPLES / run.script).parent, folder, ignore=shutil.ignore_patterns("log.*", "*.png"))
        with open(folder / "screen", "w+") as screen:
            process = subprocess.Popen(run.words(folder), cwd=folder, stdout=screen, stderr=subprocess.STDOUT,
                                       stdin=subprocess.DEVNULL)
            stop = time.time() + run.limit
            while True:    # wait4 tells the processor time of this process and its children alone
                pid, status, usage = os.wait4(process.pid, os.WNOHANG)
                if pid:
                    break
                if time.time() > stop:
                    process.kill()
                    os.wait4(process.pid, 0)
                    raise Failed(f"{run.command()}: not done after {run.limit:.0f} s")
                time.sleep(0.01)
            process.returncode = os.waitstatus_to_exitcode(status)
            screen.seek(0)
            text = screen.read()
        if process.returncode:
            error = re.findall(r"^.*ERROR.*", text, re.M)
            raise Failed(f"{run.command()}: {(error or [text[-300:]])[0]}")
        files = {f: (folder / f).read_text() for f in run.files}
    loops = re.findall(r"^Loop time of (\S+) on .* for (\d+) steps", text, re.M)
    nodes = re.search(r"(\d+) x (\d+) x (\d+) nodes", text) or re.search(r"grid of (\d+) by (\d+) by (\d+)", text)
    memory = re.findall(r"memory (\S+)\s+MiB", text)
    sizes = [int(n) for n in nodes.groups()] if nodes else [0, 0, 0]
    said = "\n".join(re.findall(r"^result .*", text, re.M))
    return {"text": said, "files": files, "wall": sum(float(t) for t, _ in loops),
            "cpu": usage.ru_utime + usage.ru_stime, "steps": sum(int(n) for _, n in loops),
            "nodes": sizes[0] * sizes[1] * sizes[2], "memory": float(memory[-1]) if memory else 0.0, "load": load}


class Store:
    """what has been run, by command, scripts and lmp; safe to stop at any moment"""

    def __init__(self, folder):
        self.file, self.done = folder / "runs.jsonl", {}
        self.lmp = hashlib.sha256(pathlib.Path(lmp).read_bytes()).hexdigest()
        if self.file.exists():
            for line in self.file.read_text().splitlines():
                try:
                    self.done.update([json.loads(line)])
                except ValueError:    # cut off when it was stopped
                    pass

    def key(self, run):
        path = EXAMPLES / run.script
        script = path.read_text() if path.exists() else ""
        words = [f"{k}={v}" for k, v in run.variables.items()]
        if "calibrated" in " ".join(words):
            words.append(RADII.read_text())
        return hashlib.sha256("\0".join([self.lmp, run.script, script, *words, str(run.ranks)]).encode()).hexdigest()

    def has(self, point):
        return all(self.key(run) in self.done for run in point.runs)

    def result(self, run):
        key = self.key(run)
        if key not in self.done:
            self.done[key] = launch(run)
            with open(self.file, "a") as file:
                file.write(json.dumps([key, self.done[key]]) + "\n")
        return Done(**self.done[key])


def rows(point, store, made_by):
    """lines of the table of one point"""
    done = [store.result(run) for run in point.runs]
    n = len(done)
    wall, cpu = sum(d.wall for d in done) / n, sum(d.cpu for d in done) / n
    updates = sum(d.steps * d.nodes for d in done) / n
    for found in point.evaluate(done):
        share = found.pop("share", 1.0)    # of the run that this quantity is, say one place of several
        row = {"case": point.case, "sweep": point.sweep, "r_over_dx": f"{point.r:.4g}", "tau": f"{point.tau:.4g}",
               **DEFAULT, **point.choice, "scatter": "", "ranks": point.runs[0].ranks,
               "wall_s": f"{wall * share:.4g}", "cpu_s": f"{cpu * share:.4g}", "steps": f"{done[0].steps * share:.0f}",
               "node_updates": f"{updates * share:.4g}", "mlups": f"{updates / max(wall, 1e-9) * 1e-6:.4g}",
               "memory_mib": f"{max(d.memory for d in done):.4g}", "load": f"{max(d.load for d in done):.2f}", **made_by}
        row.update({"error": found["value"] / (found["reference"] or math.nan) - 1.0, **found})
        for name in ("value", "reference", "error", "scatter"):
            if row[name] != "":
                row[name] = f"{row[name]:.6g}"
        yield {name: row[name] for name in COLUMNS}
