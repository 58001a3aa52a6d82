"""What ./run accuracy runs, and against which numbers: one choice at a time around the default, and the crossings
that matter. References are known solutions or measurements; where there is none, own runs extrapolated (OWN)."""
import math
import re

from accuracy_run import DEFAULT, EXAMPLES, RADII, Point, Run, words_after

PI = math.pi
OWN = ("permeability", "restitution_water")    # of order 2, see references()
RULES = ("cli", "zhao", "bouzidi", "halfway")


def choose(**choice):
    """what differs from the default"""
    return {k: v for k, v in choice.items() if DEFAULT.get(k) != v}


def with_radii(tau):
    """rules beside the default whose radii are in the table by now: the call after the one that kept them"""
    known = [line.split()[:2] for line in RADII.read_text().splitlines()] if RADII.exists() else []
    return [link for link in RULES[1:] if [link, f"{tau:.4g}"] in known]


def keywords(choice):
    """values of the variables "collision" and "link" of a script, the latter followed by what has no variable"""
    full = {**DEFAULT, **choice}
    more = "".join(f" {k} {full[k]}" for k in ("refill", "average", "precision", "radius") if k in choice)
    return {"collision": full["collision"], "link": full["link"] + more}


# ---- simple cubic arrays: Zick & Homsy 1982

KNOWN = {0.125: 4.292, 0.45: 28.1}


def array(phi, cells, tau=2.0, sweep="dx", places=8, **choice):
    choice = choose(**choice)
    r = cells * (0.75 * phi / PI)**(1 / 3)

    def evaluate(done):
        K, spread, _ = (float(w) for w in done[0].files["arrays.dat"].split()[-3:])
        return [{"quantity": "drag", "value": K, "reference": KNOWN[phi], "scatter": spread, "share": 1 / places}]

    run = Run("periodic_arrays/in.periodic_arrays", {"phi": phi, "cells": cells, "tau": tau, "table": "arrays.dat",
              "places": places, **keywords(choice)}, files=("arrays.dat",))
    steps = 0.85 * cells**2 / ((tau - 0.5) / 3)
    return Point(f"array_{phi:g}", sweep, [run], evaluate, r, tau, choice, places * steps * cells**3)


def arrays(phi, quick):
    fine = {0.125: [7, 8, 10, 13, 16, 20, 25, 33], 0.45: [5, 6, 8, 10, 13, 16, 21]}[phi]
    some = {0.125: [8, 13, 20], 0.45: [6, 10, 16]}[phi]
    if quick:
        return [array(phi, n) for n in some[:2]] + [array(phi, some[0], tau, "link", link=link)
                                                    for link, tau in (("bouzidi", 0.8), ("zhao", 0.8))]
    points = [array(phi, n) for n in fine]
    points += [array(phi, some[1], tau, "tau") for tau in (0.52, 0.55, 0.6, 0.8, 1.0, 1.5, 3.0)]
    points += [array(phi, n, tau, "link", link=link) for link in RULES[1:] for tau in (0.6, 0.8, 1.0, 2.0) for n in some
               if tau > 0.6 or n < some[2]]
    points += [array(phi, some[0], tau, "link") for tau in (0.6, 0.8, 1.0)]
    points += [array(phi, some[1], tau, "collision", collision="bgk", link=link)
               for link in ("cli", "bouzidi", "halfway") for tau in (0.6, 0.8, 1.0, 1.5)]
    points += [array(phi, n, 2.0, "collision", collision=f"trt {magic}") for magic in (0.0833333, 0.25) for n in some[:2]]
    points += [array(phi, n, 2.0, "collision", collision="trt 0.17") for n in some]
    points += [array(phi, n, 2.0, "precision", precision="single") for n in some]
    if phi == 0.45:    # the table is made from the other one
        points += [array(phi, n, 2.0, "radius", radius="calibrated") for n in fine]
        points += [array(phi, n, 0.8, "radius", radius="calibrated", link=link) for link in with_radii(0.8) for n in some]
    return points


# ---- sphere between plates in Poiseuille flow

def plates_reference(ratio):
    """F at D/r, as examples/poiseuille_sphere/check.py interpolates: (limit - F) (D/r)^2 varies little"""
    text = (EXAMPLES / "poiseuille_sphere" / "reference.txt").read_text()
    rows = [[float(x) for x in line.split()] for line in text.splitlines() if line[0] != "#"]
    rows, limit = rows[:-1], rows[-1][1]
    above = next((k for k in range(len(rows)) if rows[k][0] >= ratio), len(rows) - 1)
    used = rows[min(max(above - 2, 0), len(rows) - 4):][:4]
    weight = lambda row: math.prod(math.log(ratio / o[0]) / math.log(row[0] / o[0]) for o in used if o is not row)
    return limit - sum(weight(row) * (limit - row[1]) * (row[0] / ratio)**2 for row in used)


def plate(cells, tau=3.0, sweep="dx", **choice):
    choice = choose(**choice)
    D = round(1.32 * cells)

    def evaluate(done):
        F = [float(d.files["plates.dat"].split()[-4]) for d in done]    # rules may be several words
        mean = sum(F) / len(F)
        spread = math.sqrt(sum((f - mean)**2 for f in F) / len(F)) / mean
        return [{"quantity": "drag", "value": mean, "reference": plates_reference(D / (0.11 * cells)),
                 "scatter": spread}]

    runs = [Run("poiseuille_sphere/in.poiseuille_sphere", {"cells": cells, "D": D, "tau": tau, "sx": sx, "sy": sy,
                "out": "plates.dat", **keywords(choice)}, files=("plates.dat",))
            for sx in (0, 0.5) for sy in (0, 0.5)]
    return Point("plates", sweep, runs, evaluate, 0.11 * cells, tau, choice,
                 4 * 0.6 * cells**2 / ((tau - 0.5) / 3) * cells * D**2)


def plates(quick):
    if quick:
        return [plate(20)]
    return [plate(n) for n in (20, 24, 28, 32, 40, 50, 60)] + \
        [plate(n, sweep="place") for n in (26, 30)] + \
        [plate(28, tau, "tau") for tau in (0.7, 1.0, 2.0)] + \
        [plate(n, tau, "link", link=link) for link in RULES[1:] for tau in (1.0, 3.0) for n in (20, 28, 40)
         if tau == 3.0 or n == 28] + \
        [plate(n, 3.0, "collision", collision="trt 0.17") for n in (20, 28, 40)] + \
        [plate(28, 0.7, "collision", collision="bgk", link=link) for link in ("cli", "bouzidi")] + \
        [plate(28, 3.0, "precision", precision="single")] + \
        [plate(n, 3.0, "radius", radius="calibrated") for n in (20, 24, 28, 32, 40)] + \
        [plate(28, 1.0, "radius", radius="calibrated", link=link) for link in with_radii(1.0)]


# ---- moving sphere against a fixed one, from when the sphere has passed 1.5 r, over 4 r

def moving(r, tau=0.63, sweep="dx", **choice):
    choice = choose(**choice)
    scale = (r / 5.5)**2 * 0.13 / (tau - 0.5)
    first, last, length = round(200 * scale), round(760 * scale), round(12 * r)

    def evaluate(done):
        moved, fixed = ([float(line.split()[1]) for line in d.files["force.dat"].splitlines() if line[0] != "#"]
                        for d in done)
        error = [m / f - 1 for m, f in zip(moved[first:], fixed[first:])]
        bias, rms = sum(error) / len(error), math.sqrt(sum(e * e for e in error) / len(error))
        cost = {"share": 1.0}    # of one of the two
        return [{"quantity": "moving_rms", "value": rms, "reference": 0.0, "error": rms, **cost},
                {"quantity": "moving_bias", "value": bias, "reference": 0.0, "error": bias, **cost}]

    full = {**DEFAULT, **choice}
    words = {"collision": full["collision"], "link": full["link"] + (" precision single" if "precision" in choice else ""),
             "average": full["average"], "r": r, "tau": tau, "length": length, "steps": last}
    # a fixed sphere uncovers nothing: one run for all rules of refilling
    runs = [Run("moving_sphere/in.moving_sphere", {"motion": motion, "refill": refill, **words}, files=("force.dat",))
            for motion, refill in (("moving", full["refill"]), ("fixed", "grad"))]
    return Point("moving", sweep, runs, evaluate, r, tau, choice, 2 * last * length * round(6 * r) * round(r / 0.11))


def movings(quick):
    if quick:
        return [moving(3.5), moving(3.5, sweep="refill", refill="local")]
    points = [moving(r) for r in (3.0, 3.52, 4.4, 5.5, 7.0, 8.8)]
    points += [moving(5.5, tau, "tau") for tau in (0.53, 0.56, 0.7, 0.8)]
    points += [moving(5.5, sweep="refill", refill=refill) for refill in ("normal", "local", "equilibrium")]
    points += [moving(5.5, sweep="link", link=link) for link in RULES[1:]]
    points += [moving(5.5, sweep="average", average="no")]
    points += [moving(5.5, sweep="precision", precision="single")]
    points += [moving(5.5, sweep="collision", collision=f"trt {magic}") for magic in (0.05, 0.0833333, 0.25)]
    points += [moving(5.5, tau, "collision", collision="bgk", link=link)
               for link in ("cli", "bouzidi", "zhao") for tau in (0.63, 0.7)]
    points += [moving(5.5, sweep="collision", collision="bgk", link=link, refill=refill)
               for link, refill in (("zhao", "normal"), ("bouzidi", "equilibrium"))]
    points += [moving(5.5, sweep="link", link=link, refill="normal") for link in ("bouzidi", "zhao")]
    return points


# ---- settling sphere: ten Cate et al. 2002

MEASURED = {"E1": 0.03599, "E3": 0.08727}
# 15 cells per diameter, examples/settling_sphere. Not extrapolated: between 9 and 15 cells the speed goes up and down by
# 0.3 %, with the places of the lattice that the sphere passes. Of E1 no more can be said: what was measured is 1.1 %
# above what Stokes' drag in a duct of that width allows.
FINE = {"E1": 0.03487, "E3": 0.08728}


def settle(case, cells, mach=0.09, tau=1.5, sweep="dx", **choice):
    choice = choose(**choice)

    def evaluate(done):
        table = done[0].files[f"settling-{case}-{cells}.dat"]
        v = [float(line.split()[2]) for line in table.splitlines() if line[0] != "#"]
        return [{"quantity": f"settling_{case}", "value": -min(v), "reference": FINE[case]},
                {"quantity": f"settling_{case}_measured", "value": -min(v), "reference": MEASURED[case]}]

    run = Run("settling_sphere/in.settling_sphere", {"case": case, "cells": cells, "mach": mach, "tau": tau,
              **keywords(choice)}, ranks=2, files=(f"settling-{case}-{cells}.dat",))
    u, nu = {"E1": (0.038, 0.373 / 970), "E3": (0.091, 0.113 / 962)}[case]
    dx = 0.015 / cells
    dt = min(mach * dx / (math.sqrt(3) * u), (tau - 0.5) * dx**2 / (3 * nu))
    steps = {"E1": 3.8, "E3": 1.75}[case] / dt
    found = 0.5 + 3 * nu * dt / dx**2
    return Point(f"settling_{case}", sweep, [run], evaluate, cells / 2, found, choice, steps * 0.0016 / dx**3)


def settlings(quick):
    if quick:
        return [settle("E3", 6)]
    return [settle("E3", n) for n in (6, 9, 12)] + [settle("E1", n) for n in (6, 9, 12)] + \
        [settle("E3", 9, mach, sweep="tau") for mach in (0.18, 0.045)] + \
        [settle("E1", 6, 0.09, tau, "tau") for tau in (0.8, 1.0)] + \
        [settle("E3", n, sweep="link", link=link) for link in RULES[1:] for n in (6, 9)] + \
        [settle("E3", 9, sweep="collision", collision="bgk", link="bouzidi"),
         settle("E3", 9, sweep="refill", refill="equilibrium"), settle("E3", 9, sweep="refill", refill="normal"),
         settle("E3", 9, sweep="average", average="no"), settle("E3", 9, sweep="precision", precision="single"),
         settle("E3", 6, sweep="radius", radius="calibrated"), settle("E3", 9, sweep="radius", radius="calibrated")]


# ---- permeability of a random bed

BED = 2.261e-10    # what 15 and 20 cells per diameter tend to within 0.1 %, if nothing finer has been run


def bed(cells, tau=1.0, sweep="dx", **choice):
    choice = choose(**choice)

    def evaluate(done):
        k = float(done[0].files["bed.dat"].split()[-4])
        return [{"quantity": "permeability", "value": k, "reference": math.nan}]

    run = Run("permeability/in.permeability", {"cells": cells, "tau": tau, "table": "bed.dat", **keywords(choice)},
              files=("bed.dat",))
    steps = 9 * (50 + 0.1 * cells**2 / ((tau - 0.5) / 3))
    return Point("bed", sweep, [run], evaluate, cells / 2, tau, choice, 0.8 * steps * (3.6 * cells)**3)


def beds(quick):
    if quick:
        return [bed(n) for n in (5, 7.5)]
    return [bed(n) for n in (5, 7.5, 10, 15, 20, 25)] + \
        [bed(10, tau, "tau") for tau in (0.52, 0.55, 0.6, 0.8, 1.5, 2.0)] + \
        [bed(n, tau, "link", link=link) for link in RULES[1:] for tau in (0.6, 1.0) for n in (10, 15)
         if tau == 1.0 or n == 10] + \
        [bed(n, 1.0, "collision", collision="trt 0.17") for n in (5, 7.5, 10, 15)] + \
        [bed(10, tau, "collision", collision="bgk", link=link) for tau in (0.6, 1.0, 1.5) for link in ("cli", "bouzidi")] + \
        [bed(10, 1.0, "precision", precision="single")] + \
        [bed(n, 1.0, "radius", radius="calibrated") for n in (5, 7.5, 10, 15)] + \
        [bed(10, 1.0, "radius", radius="calibrated", link=link) for link in with_radii(1.0)]


# ---- approach to a wall: Brenner 1961

def brenner(gap):
    """force over Stokes's on a sphere that approaches a plane, gap over radius"""
    a = math.acosh(1 + gap)
    total = 0.0
    for n in range(1, 2000):
        top = 2 * math.sinh((2 * n + 1) * a) + (2 * n + 1) * math.sinh(2 * a)
        low = 4 * math.sinh((n + 0.5) * a)**2 - (2 * n + 1)**2 * math.sinh(a)**2
        term = n * (n + 1) / ((2 * n - 1) * (2 * n + 3)) * (top / low - 1)
        total += term
        if abs(term) < 1e-10 * total or (2 * n + 3) * a > 300:
            break
    return 4 / 3 * math.sinh(a) * total


def approach(r, tau=2.0, sweep="dx", **choice):
    choice = choose(**choice)

    def evaluate(done):
        table = [[float(x) for x in line.split()] for line in done[0].files["lubrication.dat"].splitlines()
                 if line[0] != "#"]
        for gap in (0.5, 0.2, 0.1, 0.05):
            near = [g * F for g, F in table if abs(g - gap) < 0.1 * gap]    # g F varies little
            if near:
                yield {"quantity": f"lubrication_gap_{gap:g}r", "value": sum(near) / len(near) / gap,
                       "reference": brenner(gap)}

    run = Run("accuracy/in.lubrication", {"r": r, "tau": tau, **keywords(choice)}, files=("lubrication.dat",))
    return Point("lubrication", sweep, [run], evaluate, r, tau, choice, 0.96 * r * r / 0.02 / ((tau - 0.5) / 3) * 800 * r**3)


def approaches(quick):
    if quick:
        return [approach(2.5)]
    return [approach(r) for r in (3.0, 5.0, 8.0)] + [approach(5.0, sweep="link", link=link) for link in RULES[1:]] + \
        [approach(5.0, 1.0, "tau")]


# ---- fluid alone

def vortices(n, tau, Re=10.0, sweep="dx", **choice):
    choice = choose(**choice)
    full = {**DEFAULT, **choice}

    def evaluate(done):
        yield {"quantity": "velocity", "value": words_after(done[0].text, "result")["error"], "reference": 0.0,
               "error": words_after(done[0].text, "result")["error"]}

    run = Run("bench/taylor_green", {"n": n, "tau": tau, "Re": Re, "collision": full["collision"],
                                     "precision": full["precision"]})
    return Point("taylor_green", sweep, [run], evaluate, n / 2, tau, choice, n**4 * 0.0088 / ((tau - 0.5) / 3))


def taylor_green(quick):
    sizes = [16, 32] if quick else [16, 24, 32, 48, 64, 96]
    taus = [0.55, 0.8] if quick else [0.505, 0.51, 0.52, 0.55, 0.6, 0.7, 0.8, 1.0, 1.2, 1.5, 2.0]
    slow_enough = lambda n, tau: 30.0 * (tau - 0.5) / 3 / n < 0.17
    points = [vortices(n, tau, 30.0) for tau in taus for n in sizes if slow_enough(n, tau)]
    if not quick:
        points += [vortices(n, tau, 30.0, "collision", collision="bgk") for tau in (0.51, 0.55, 0.6, 0.8) for n in sizes]
        points += [vortices(n, tau, 30.0, "collision", collision="regularised") for tau in (0.51, 0.6, 0.8) for n in sizes
                   if slow_enough(n, tau)]
        points += [vortices(n, 0.55, 30.0, "precision", precision="single") for n in sizes]
    return points


def womersley_mean(n, nu, accel, H, step):
    """mean velocity at a step of a drive accel cos(2 pi step/n)"""
    import cmath
    omega = 2 * PI / n
    k = cmath.sqrt(1j * omega / nu) * H / 2
    return (accel / (1j * omega) * (1 - cmath.tanh(k) / k) * cmath.exp(1j * omega * step)).real


def womersley(cells, tau=0.8, sweep="dx", **choice):
    choice = choose(**choice)
    full = {**DEFAULT, **choice}

    def evaluate(done):
        v = words_after(done[0].text, "result")
        n, H = int(v["n"]), int(v["cells"])
        u = [float(line.split()[1]) for line in done[0].files["womersley.dat"].splitlines() if line[0] != "#"]
        last = range(len(u) - n, len(u))    # rows begin with step 0
        # what is evaluated at the end of a time step drives the fluid from the beginning of its own on
        exact = [womersley_mean(n, v["nu"], v["accel"], H, t + 1) for t in last]
        error = math.sqrt(sum((u[t] - e)**2 for t, e in zip(last, exact)) / sum(e * e for e in exact))
        yield {"quantity": "velocity", "value": error, "reference": 0.0, "error": error}

    run = Run("accuracy/in.womersley", {"cells": cells, "tau": tau, "collision": full["collision"],
              "precision": full["precision"]}, files=("womersley.dat",))
    return Point("womersley", sweep, [run], evaluate, cells / 2, tau, choice, cells**3 * 16 / ((tau - 0.5) / 3))


def womersleys(quick):
    if quick:
        return [womersley(n) for n in (8, 16)]
    return [womersley(n) for n in (8, 12, 16, 24, 32, 48)] + \
        [womersley(16, tau, "tau") for tau in (0.51, 0.55, 0.6, 1.0, 1.5)] + \
        [womersley(16, tau, "collision", collision="bgk") for tau in (0.55, 0.8, 1.5)] + \
        [womersley(16, 0.8, "precision", precision="single")]


# ---- impacts: restitution against the time step, dry, and against granular steps per fluid step, in water

def impact(contact, every, rho, sweep):
    def evaluate(done):
        lines = [[float(w) for w in line.split()] for line in done[0].files["impact.dat"].splitlines() if line[0] != "#"]
        parted = next(k for k in range(2, len(lines)) if lines[k][1] >= 2 * 3.975)
        e = lines[parted][2] / 0.04
        if rho < 0.1:
            yield {"quantity": "restitution", "value": e, "reference": 0.9}
        else:
            yield {"quantity": "restitution_water", "value": e, "reference": math.nan}

    run = Run("extreme/in.contact", {"contact": contact, "every": every, "rho": rho, "rounds": 1}, files=("impact.dat",))
    return Point("impact_dry" if rho < 0.1 else "impact_water", sweep, [run], evaluate, contact, 0.8,
                 {}, 5 * contact / every * 2304)


def impacts(quick):
    if quick:
        return [impact(n, 50, 1e-6, "steps_per_contact") for n in (10, 40)]
    return [impact(n, 50, 1e-6, "steps_per_contact") for n in (10, 12, 15, 20, 30, 50, 100, 200, 500)] + \
        [impact(n, n // 2, 1.0, "steps_per_contact") for n in (10, 20, 40, 100, 200, 400)]


# ---- LAMMPS's own fix lb/fluid on the arrays, fixed, and moving beside our own

SHELLS = ((2, 0.4), (3, 0.5), (4, 0.15))    # stencil, and how far inside the points fit drag at .125 best at tau = 1


def peer(stencil, less):
    return {"collision": "lb/fluid", "link": f"stencil {stencil} less {less:g}", "refill": "-", "average": "-"}


def lb_fluid(phi, cells, stencil, less=0.0, places=8):
    r = cells * (0.75 * phi / PI)**(1 / 3)

    def evaluate(done):
        v = words_after(done[0].text, "result")
        yield {"quantity": "drag", "value": v["K"], "reference": KNOWN[phi], "scatter": v["spread"], "share": 1 / places}

    run = Run("accuracy/in.lb_fluid", {"phi": phi, "cells": cells, "stencil": stencil, "less": less, "places": places})
    steps = 0.4 * cells**2 * 6
    return Point(f"lb_fluid_{phi:g}", f"stencil_{stencil}_less_{less:g}", [run], evaluate, r, 1.0, peer(stencil, less),
                 20 * places * steps * cells**3)


def moving_array(phi, cells, tau=2.0, sweep="dx", shell=None, **choice):
    """scatter: while the spheres cross the lattice; shell: (stencil, less) of lb/fluid"""
    choice = choose(**choice)
    r = cells * (0.75 * phi / PI)**(1 / 3)

    def evaluate(done):
        v = words_after(done[0].text, "result")
        yield {"quantity": "drag", "value": v["K"], "reference": KNOWN[phi], "scatter": v["spread"]}

    words = {"fluid": "lb/fluid", "stencil": shell[0], "less": shell[1]} if shell else \
        {"fluid": "lb/ibb", "radius": choice.get("radius", "given")}
    run = Run("accuracy/in.moving_array", {"phi": phi, "known": KNOWN[phi], "cells": cells, "tau": tau, **words})
    steps = 4.0 * 20 * r / ((tau - 0.5) / 3) + 0.3 * cells**2 / ((tau - 0.5) / 3)
    return Point(f"moving_array_{phi:g}", sweep, [run], evaluate, r, tau, peer(*shell) if shell else choice,
                 (10 if shell else 1) * steps * cells**3)


def lb_fluids(quick):
    if quick:    # those for which lmp needs no other package
        return [moving_array(0.125, n) for n in (8, 13)]
    fine = {0.125: (8, 13, 20), 0.45: (6, 10, 16)}
    points = [lb_fluid(0.125, n, stencil) for stencil in (2, 4) for n in (8, 13, 20) if stencil == 2 or n < 20] + \
        [lb_fluid(0.125, n, 2, 0.4) for n in (8, 13, 20)] + \
        [lb_fluid(0.125, n, *shell) for shell in SHELLS[1:] for n in (8, 13)] + \
        [lb_fluid(0.45, n, 2, less) for less in (0.0, 0.4) for n in (6, 10, 16)]
    for phi, sizes in fine.items():
        points += [moving_array(phi, n, radius=radius) for n in sizes for radius in ("given", "calibrated")]
        points += [moving_array(phi, n, 1.0, "tau") for n in sizes]
        points += [moving_array(phi, n, 1.0, f"stencil_{shell[0]}_less_{shell[1]:g}", shell)
                   for shell in ((2, 0.0), *SHELLS) for n in sizes]
    for tau in (0.6, 0.8, 1.5, 2.0):
        points += [moving_array(0.125, 13, tau, "tau", shell) for shell in SHELLS[:2]]
        points += [moving_array(0.125, 13, tau, "tau")] if tau < 2.0 else []
    return points


GROUPS = {"array_0.125": lambda quick: arrays(0.125, quick), "array_0.45": lambda quick: arrays(0.45, quick),
          "plates": plates, "moving": movings, "settling": settlings, "bed": beds, "lubrication": approaches,
          "taylor_green": taylor_green, "womersley": womersleys, "impact": impacts, "lb_fluid": lb_fluids}


def references(rows):
    """where the reference is our own: the two finest of the default, extrapolated as errors of second order"""
    for quantity in OWN:
        mine = [row for row in rows if row["quantity"] == quantity]
        fine = sorted((row for row in mine if row["sweep"] in ("dx", "steps_per_contact")),
                      key=lambda row: float(row["r_over_dx"]))
        if len(fine) < 2:
            continue
        (r1, v1), (r2, v2) = ((float(row["r_over_dx"]), float(row["value"])) for row in fine[-2:])
        exact = v2 + (v2 - v1) / ((r2 / r1)**2 - 1)
        if quantity == "permeability" and r1 < 10:    # there errors still fall faster than by second order
            exact = BED
        for row in mine:
            row["reference"], row["error"] = f"{exact:.6g}", f"{float(row['value']) / exact - 1:.6g}"
    return rows
