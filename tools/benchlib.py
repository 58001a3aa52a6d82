"""What ./run bench and ./run growth share: runs of lmp and of the machine's limits, and what they print."""
import os
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(os.environ["LBMIBB_BUILD"])
lmp = os.environ["LMP"]
out = root / "figures" / "bench"
N = 128    # nodes along an edge of the cube, if nothing else is said


def need(module, optional=False):
    """start again with the system's python3 if this one lacks a module"""
    try:
        __import__(module)
    except ImportError:
        system = "/usr/bin/python3"
        if os.path.exists(system) and not os.path.samefile(sys.executable, system):
            os.execv(system, [system, *sys.argv])
        if not optional:
            sys.exit(f"this python3 has no {module}: install python3-{module}")


def run(command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def limit(lattice="D3Q19", nodes=N, ranks=2):
    return float(run(["mpirun", "-np", ranks, build / "bench" / "limits", lattice, nodes, 0.7]))


class Run:
    """one run of an input script in bench/: speed in nodes per second of LAMMPS's loop time, and more"""

    def __init__(self, script, ranks=2, **variables):
        words = [w for name, value in variables.items() for w in ("-var", name, value)]
        text = run(["mpirun", "-np", ranks, lmp, "-in", script, "-log", "none", *words], cwd=root / "bench")
        loop, steps = re.findall(r"^Loop time of (\S+) on .* for (\d+) steps", text, re.M)[-1]
        self.seconds = float(loop) / int(steps)    # per step
        nodes = re.search(r"(\d+) x (\d+) x (\d+) nodes", text)
        self.nodes = 1
        for n in nodes.groups() if nodes else (N, N, N):
            self.nodes *= int(n)
        self.speed = self.nodes / self.seconds * 1e-6
        links = re.search(r"(\d+) cut links", text)
        self.links = int(links.group(1)) if links else 0
        memory = re.findall(r"memory (\S+)\s+MiB", text)
        self.bytes = float(memory[-1]) * 2**20 * ranks / self.nodes if memory else None
        shares = re.search(r"fluid (\S+) %, grains in and out (\S+) %", text)
        self.fluid, self.grains = (float(x) / 100 for x in shares.groups()) if shares else (None, None)


def against_limit(script, lattice="D3Q19", nodes=N, per=1.0, **variables):
    """speed over the limit measured before and after"""
    before = limit(lattice, nodes)
    done = Run(script, **variables)
    top = 0.5 * (before + limit(lattice, nodes))
    return done.speed / top / per, done.speed, top


def prepare():
    run(["cmake", "--build", build, "--target", "limits"])
    out.mkdir(parents=True, exist_ok=True)
