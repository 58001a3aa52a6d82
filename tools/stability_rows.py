"""The rows of ./run stability: single stiff, extreme or wrong set-ups, and what must become of each."""
from stability_run import Case

TAU = lambda tau: round((tau - 0.5) / 3, 10)    # viscosity of


def finite(v, _, __):
    return "" if v["rho_min"] > 0 else f"density {v['rho_min']}"


def driven(v, _, __):
    """the force on the fixed sphere is what drives the water"""
    share = v["force"] / (1e-5 * v["nodes"])
    return "" if 0.9 < share < 1.1 else f"force {share:.3f} of what drives the water"


def accelerated(v, _, __):
    """water alone: u = a t"""
    u = 1e-5 * 200
    return "" if abs(v["flux"] / u - 1) < 1e-9 else f"speed {v['flux']}, expected {u}"


def row(title, want, check=finite, ranks=1, like=None, only=(), script="in.rows", **variables):
    return Case("rows", script, variables, check, want, title, ranks, like=like, only=only)


def set_up():
    water = {"case": "still", "steps": 100}
    column = {"script": "in.column", "steps": 200}
    return [
        row("tau = 1/2", "refused: relaxation time tau", nu=1e-20, **water),
        row("tau < 0.51", "warns: is close to 1/2", nu=TAU(0.505), **water),
        row("tau > 3", "warns: accuracy is lost", nu=TAU(3.5), **water),
        row("pressure difference 6 %", "warns: changes the density by 6 %, limit 5 %", excess=0.06, **column),
        row("pressure difference 21 %", "refused: the largest relaxation time allowed here", excess=0.21, **column),
        row("Ma 0.15 at a face", "warns: compressibility spoils", script="in.sphere", Ma=0.15, steps=860, tau=1.0),
        row("Ma 0.35 at a face", "stopped: Ma = 0.3", script="in.sphere", Ma=0.35),
        row("every > 1000", "warns: more than 1000 granular steps", every=2000, case="plain", steps=4),
        row("r < 2", "refused: is 1.9 cells, limit 2", r=1.9, **water),
        row("r < 3.5", "warns: is 3 cells, limit 3.5", r=3.0, **water),
        row("dx does not divide the box", "refused: nearest that do are", dx=0.99, **water),
        row("triclinic box", "refused: triclinic", case="triclinic"),
        row("changing box", "refused: changing box", case="changing"),
        row("rRESPA", "refused: respa", case="respa"),
        row("minimisation", "refused: minimisation", case="minimise"),
        row("reset_timestep in mid-run", "stopped: ", case="reset", steps=20),
        row("another timestep in mid-run", "stopped: cannot go on with", case="longer", steps=20),
        row("2d with masses of spheres", "refused: disc", case="flat"),
        row("shrink-wrapped box", "refused: shrink-wrapped", boundary="p p s", case="still",
            drive="face zlo wall face zhi wall"),
        row("no face given", "refused: ", boundary="p p f", case="still"),
    ]


def in_course():
    return [
        row("water gets too fast", "stopped: the fluid's speed is", drive="accel 0.02 0 0", case="still"),
        row("accel beyond Ma 0.3 in a step", "refused: accel and gradp", boundary="p p f", case="empty",
            drive="accel 0 0 3.0 face zlo wall face zhi wall", options="check 1"),
        *[row("surface too fast, Ma > 0.3", "stopped: has a surface that moves", ranks=ranks, case="spinning")
          for ranks in (1, 2, 4)],
        row("grain moves 0.06 cells in a fluid step, Ma > 0.1", "warns: cells in one fluid step", case="moving", speed=0.06, steps=30,
            nu=TAU(1.0)),
        row("grain moves more than a cell", "stopped: ", case="thrown", speed=1.2),
        *[row("grain placed anew", "stopped: placed anew", ranks=ranks, case="anew", steps=10)
          for ranks in (1, 2, 4)],
        row("light grain, 0.01", "", density=0.01, drive="accel 1e-4 0 0", case="plain"),
        row("neutrally buoyant grain, 1.001", "stable", density=1.001, steps=400),
        row("sudden pressure step", "stable", script="in.column", excess=0.04, steps=4000),
        row("grain leaves through a pressure face", "stable", case="leaving", speed=0.03, x=12.0, steps=300,
            boundary="f p p", drive="face xlo pressure 0 face xhi pressure 0"),
        row("grain in a pressure face", "stable", case="still", x=15.5, boundary="f p p",
            drive="face xlo pressure 0.001 face xhi pressure 0"),
        row("grain in a wall", "stable", case="still", z=0.5, boundary="p p f",
            drive="accel 1e-5 0 0 face zlo wall face zhi wall"),
        row("no grains at all", "stable", accelerated, case="empty"),
        row("all nodes solid", "stable", case="still", r=14.0, steps=20),
        row("no open path", "stable", case="still", r=9.0),
        row("enclosed pockets", "stable", case="still", r=11.0),
        row("node exactly on the surface, q = 0", "stable", driven, case="still", x=8.5, y=8.5, z=8.5, steps=2000),
        row("one-cell gap", "stable", script="in.pair", gap=1.0, mode="flow"),
    ]


def same_anywhere():
    """across faces, edges and corners of the box and of ranks: the same to round-off"""
    still = {"case": "still", "x": 8.25, "y": 8.125, "z": 7.75}
    middle = row("sphere in the middle", "stable", **still)
    places = [("face", 0.25, 8.125, 7.75), ("edge", 0.25, 0.125, 7.75), ("corner", 0.25, 0.125, 15.75)]
    same = {"like": middle, "only": ("force", "nodes", "flux")}
    cases = [middle]
    for name, x, y, z in places:
        for ranks in (1, 2, 4):
            cases.append(row(f"sphere across a periodic {name}", "stable", ranks=ranks, **same,
                             **{**still, "x": x, "y": y, "z": z}))
    large = row("sphere larger than a sub-domain", "stable", **{**still, "r": 7.0})
    cases += [large, row("sphere larger than a sub-domain", "stable", ranks=4, **{**same, "like": large},
                         **{**still, "r": 7.0})]
    deep = row("overlapping spheres", "stable", script="in.pair", gap=-1.0, mode="flow", steps=200)
    cases += [deep] + [row("overlapping spheres", "stable", script="in.pair", gap=-1.0, mode="flow", steps=200,
                           ranks=ranks, like=deep, only=("fx1", "fx2", "nodes")) for ranks in (2, 4)]
    return cases


def rows(quick):
    if quick:    # one of each kind of outcome, and every one that takes no time
        return set_up()[:1] + in_course()[:5] + same_anywhere()[:3]
    return set_up() + in_course() + same_anywhere()
