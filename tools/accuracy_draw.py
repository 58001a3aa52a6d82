"""Figures of ./run accuracy: error against cost, resolution, tau, and what the rules do to a moving sphere."""
import math

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError:
    plt = None

from accuracy_tables import CASES_3D, error, floors, front, is_default, number, of, refinement

COLOUR = {"cli": "C0", "zhao": "C2", "bouzidi": "C1", "halfway": "C3"}
TITLE = {"array_0.125": "cubic array, solid fraction .125", "array_0.45": "cubic array, .45",
         "plates": "sphere between plates", "moving": "moving sphere, rms", "settling_E1": "settling, E1",
         "settling_E3": "settling, E3", "bed": "permeability of a random bed"}
PEERS = {"lb/ibb": "C0", "lb/ibb, radius calibrated": "C9", "lb/fluid, stencil 2 less 0": "C1",
         "lb/fluid, stencil 2 less 0.4": "C3", "lb/fluid, stencil 3 less 0.5": "C2", "lb/fluid, stencil 4 less 0": "C4",
         "lb/fluid, stencil 4 less 0.15": "C5"}
MOST = 1.0    # what is more wrong is counted, not shown


def marker(row):
    if row["precision"] == "single":
        return "x"
    if row["radius"] == "calibrated":
        return "*"
    return {"trt": "o", "bgk": "s"}.get(row["collision"].split()[0], "d")


def scatter(ax, rows, x):
    for row in rows:
        ax.loglog(number(row, x), 100 * error(row), marker(row), ms=4, mfc="none", alpha=0.8,
                  color=COLOUR.get(row["link"], "0.4"))


def cost(table, out):
    """error against node updates: every choice, the front, the slope of theory"""
    cases = [case for case in CASES_3D if len(of(table, case)) > 2]
    if not cases:
        return
    columns = min(4, len(cases))
    figure, axes = plt.subplots(math.ceil(len(cases) / columns), columns, squeeze=False,
                                figsize=(4.1 * columns, 3.6 * math.ceil(len(cases) / columns)))
    for ax in axes.flat[len(cases):]:
        ax.set_axis_off()
    for ax, case in zip(axes.flat, cases):
        rows = [r for r in of(table, case) if error(r) <= MOST]
        beyond = len(of(table, case)) - len(rows)
        scatter(ax, rows, "node_updates")
        best = front(rows, "node_updates")
        ax.loglog([number(r, "node_updates") for r in best], [100 * error(r) for r in best], "k-", lw=1)
        mine = refinement(table, case)
        if len(mine) > 1:
            x0, y0, x1 = number(mine[0], "node_updates"), 100 * error(mine[0]), number(mine[-1], "node_updates")
            ax.loglog([x0, x1], [y0, y0 * (x1 / x0)**-0.4], "k:", lw=1)
            ax.loglog([number(r, "node_updates") for r in mine], [100 * error(r) for r in mine], "C0-", lw=2, alpha=0.4)
        ax.set_title(TITLE[case] + (f", {beyond} above {100 * MOST:.0f} %" if beyond else ""), fontsize=9)
        ax.set_xlabel("node updates", fontsize=8)
        ax.set_ylabel("error and scatter (%)", fontsize=8)
    handles = [plt.Line2D([], [], marker="o", ls="", mfc="none", color=c, label=name) for name, c in COLOUR.items()]
    handles += [plt.Line2D([], [], marker=m, ls="", mfc="none", color="0.4", label=n)
                for m, n in (("s", "bgk"), ("d", "other Lambda"), ("x", "single precision"), ("*", "radius calibrated"))]
    handles += [plt.Line2D([], [], color="C0", lw=2, alpha=0.4, label="default, refined"),
                plt.Line2D([], [], color="k", lw=1, label="front"),
                plt.Line2D([], [], color="k", ls=":", lw=1, label="slope -2/5")]
    figure.legend(handles=handles, loc="lower center", ncol=6, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0.07, 1, 1))
    save(figure, out, "cost")


def peer(table, out):
    """arrays, fixed and moving, by LAMMPS's own fix lb/fluid too, against core seconds of whole processes"""
    figure, axes = plt.subplots(2, 2, figsize=(10, 7.4))
    shown = {}
    for column, phi in enumerate(("0.125", "0.45")):
        for ax, mine, other, cost in zip(axes[:, column], (f"array_{phi}", f"moving_array_{phi}"),
                                         (f"lb_fluid_{phi}", f"moving_array_{phi}"),
                                         ("one place", "a way of four cells")):
            kinds = {"lb/ibb": refinement(table, mine),
                     "lb/ibb, radius calibrated": [r for r in of(table, mine) if r["radius"] == "calibrated"
                                                   and r["link"] == "cli"]}
            theirs = [r for r in table if r["case"] == other and r["collision"] == "lb/fluid" and r["sweep"] != "tau"]
            for words in sorted({r["link"] for r in theirs}):
                kinds[f"lb/fluid, {words}"] = [r for r in theirs if r["link"] == words]
            for name, rows in kinds.items():
                if rows:
                    rows = sorted(rows, key=lambda r: number(r, "r_over_dx"))
                    shown[name], = ax.loglog([number(r, "cpu_s") for r in rows], [100 * error(r) for r in rows], "o-", ms=4,
                                             color=PEERS.get(name))
                    if mine != f"array_{phi}":
                        ax.loglog([number(r, "cpu_s") for r in rows], [100 * number(r, "scatter") for r in rows], ":",
                                  color=shown[name].get_color(), lw=1)
            ax.set_title(("moving " if mine == other else "fixed ") + TITLE[f"array_{phi}"], fontsize=9)
            ax.set_xlabel(f"core seconds for {cost}")
            ax.set_ylabel("error and fluctuation; it alone dotted (%)" if mine == other else "error and scatter (%)")
    figure.legend(shown.values(), shown.keys(), loc="lower center", ncol=4, fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    save(figure, out, "peer")


def order(table, out):
    """error of the default against cells per radius"""
    figure, ax = plt.subplots(figsize=(6, 4.2))
    for case in CASES_3D:
        mine = refinement(table, case)
        if len(mine) > 1:
            ax.loglog([number(r, "r_over_dx") for r in mine], [100 * error(r) for r in mine], "o-", ms=4, label=TITLE[case])
    ax.loglog([2, 16], [8, 8 / 64], "k:", lw=1, label="second order")
    ax.set_xlabel(r"cells per radius $r/\Delta x$")
    ax.set_ylabel("error and scatter of the default (%)")
    ax.legend(fontsize=7)
    save(figure, out, "order")


def tau(table, out):
    """signed error against tau, at the same resolution"""
    cases = [c for c in ("array_0.125", "array_0.45", "plates", "bed")
             if len({r["tau"] for r in of(table, c)}) > 2]
    if not cases:
        return
    figure, axes = plt.subplots(1, len(cases), figsize=(4 * len(cases), 3.6), squeeze=False)
    for ax, case in zip(axes[0], cases):
        rows = of(table, case)
        sizes = [r["r_over_dx"] for r in rows if r["sweep"] == "tau"]
        rows = [r for r in rows if sizes and r["r_over_dx"] == sizes[0] and r["precision"] == "double"
                and r["radius"] == "given"]
        for name in sorted({(r["collision"], r["link"]) for r in rows}):
            some = sorted((number(r, "tau"), 100 * number(r, "error")) for r in rows
                          if (r["collision"], r["link"]) == name)
            if len(some) > 1:
                ax.plot(*zip(*some), "o-" if name[0] == "trt" else "s--", ms=4, color=COLOUR[name[1]], mfc="none",
                        label=" ".join(name))
        ax.axhline(0, color="0.6", lw=0.8)
        ax.set_xlabel(r"$\tau$")
        ax.set_ylabel("error (%)")
        ax.set_title(f"{TITLE[case]}, r = {float(sizes[0]):.3g} cells" if sizes else TITLE[case], fontsize=9)
        ax.legend(fontsize=7)
    save(figure, out, "tau")


def surface(table, out):
    """vortices: error over resolution and tau, against cost, and against the Mach number with the floor fitted"""
    rows = [r for r in of(table, "taylor_green") if r["collision"] == "trt" and r["precision"] == "double"]
    taus, sizes = (sorted({number(r, name) for r in rows}) for name in ("tau", "r_over_dx"))
    if len(taus) < 3 or len(sizes) < 3:
        return
    found = {(number(r, "tau"), number(r, "r_over_dx")): error(r) for r in rows}
    figure, axes = plt.subplots(1, 3, figsize=(16, 4.2))
    grid = [[math.log10(found.get((t, n), math.nan)) for n in sizes] for t in taus]
    picture = axes[0].contourf(sizes, [t - 0.5 for t in taus], grid, levels=14, cmap="viridis")
    axes[0].set_xscale("log")
    axes[0].set_yscale("log")
    axes[0].set_xlabel("nodes per half period")
    axes[0].set_ylabel(r"$\tau - 1/2$, as the fluid time step at equal size")
    figure.colorbar(picture, label="log10 of the error of the velocity")
    for k, t in enumerate(taus):
        some = sorted((number(r, "node_updates"), 100 * error(r)) for r in rows if number(r, "tau") == t)
        axes[1].loglog(*zip(*some), "o-", ms=3, color=plt.cm.viridis(k / len(taus)), label=rf"$\tau$ = {t:g}")
    best = front(rows, "node_updates")
    axes[1].loglog([number(r, "node_updates") for r in best], [100 * error(r) for r in best], "k-", lw=1, label="front")
    axes[1].set_xlabel("node updates")
    axes[1].set_ylabel("error of the velocity (%)")
    axes[1].legend(fontsize=7)
    found = floors(table)
    for k, (n, (points, (a, b, c), _, _)) in enumerate(found.items()):
        colour = plt.cm.plasma(k / max(1, len(found)))
        axes[2].loglog([m for m, _ in points], [100 * e for _, e in points], "o", ms=4, color=colour, label=f"{n:.0f} nodes")
        fine = [points[0][0] * (points[-1][0] / points[0][0])**(i / 100) for i in range(101)]
        axes[2].loglog(fine, [100 * math.sqrt(max(a + b * m**2 + c * m**4, 0)) for m in fine], "-", lw=1, color=colour)
    if found:
        _, (_, _, c), _, _ = list(found.values())[-1]
        line = [0.03, 0.3]
        axes[2].loglog(line, [100 * math.sqrt(max(c, 0)) * m**2 for m in line], "k:", lw=1, label=f"{math.sqrt(max(c, 0)):.2g} Ma^2")
    axes[2].set_xlabel("Ma, by the time step at one spacing")
    axes[2].set_ylabel("error of the velocity (%)")
    axes[2].legend(fontsize=7)
    save(figure, out, "surface")


def moving(table, out):
    """rms of the force on the moving sphere, by rules"""
    rows = [r for r in of(table, "moving") if r["sweep"] not in ("dx", "tau") or
            (r["sweep"] == "dx" and r["r_over_dx"] == "5.5")]
    if len(rows) < 3:
        return
    rows.sort(key=error)
    figure, ax = plt.subplots(figsize=(7, 0.6 + 0.24 * len(rows)))
    ax.barh([f"{r['collision']} {r['link']} {r['refill']}" + (" one step" if r["average"] == "no" else "")
             + (" single" if r["precision"] == "single" else "") for r in rows], [100 * error(r) for r in rows],
            color=["C0" if is_default(r) else "0.7" for r in rows])
    ax.set_xscale("log")
    ax.set_xlabel("rms of the force against that on the fixed sphere (%), r = 5.5 cells")
    ax.tick_params(labelsize=7)
    ax.invert_yaxis()
    save(figure, out, "moving")


def small(table, out):
    """approach to a wall against the gap in cells, impacts against steps per contact, Womersley's flow"""
    figure, axes = plt.subplots(1, 3, figsize=(13, 3.8))
    rows = [r for r in table if r["case"] == "lubrication"]
    for key in sorted({(number(r, "r_over_dx"), r["link"], r["tau"]) for r in rows}):
        some = sorted((float(r["quantity"].split("_")[2][:-1]) * number(r, "r_over_dx"), 100 * number(r, "error")) for r in rows
                      if (number(r, "r_over_dx"), r["link"], r["tau"]) == key)
        axes[0].semilogx(*zip(*some), "o-", ms=4, label=f"r = {key[0]:g}, {key[1]}, tau {key[2]}")
    axes[0].axhline(0, color="0.6", lw=0.8)
    axes[0].set_xlabel("gap in cells")
    axes[0].set_ylabel("error of the force (%)")
    for case in ("impact_dry", "impact_water"):
        some = sorted((number(r, "r_over_dx"), 100 * error(r)) for r in table if r["case"] == case and error(r) > 0)
        if some:
            axes[1].loglog(*zip(*some), "o-", ms=4, label=case.replace("_", ", "))
    axes[1].set_xlabel("time steps of a contact")
    axes[1].set_ylabel("error of the restitution (%)")
    rows = of(table, "womersley")
    scatter(axes[2], rows, "r_over_dx")
    axes[2].set_xlabel("cells per half width, Womersley's flow")
    axes[2].set_ylabel("error of the mean velocity (%)")
    for ax in axes[:2]:
        if ax.get_legend_handles_labels()[0]:
            ax.legend(fontsize=7)
    save(figure, out, "other")


def save(figure, out, name):
    if not figure.get_layout_engine() and name not in ("cost", "peer"):
        figure.tight_layout()
    figure.savefig(out / f"accuracy_{name}.png", dpi=90)
    plt.close(figure)


def draw(table, out):
    if plt is None:
        print("no matplotlib: no figures")
        return
    for make in (cost, peer, order, tau, surface, moving, small):
        make(table, out)
