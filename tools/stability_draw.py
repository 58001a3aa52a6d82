"""Maps of ./run stability, one for each sweep, and the tables of its page."""
import textwrap

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.patches import Patch
except ImportError:
    plt = None

from stability_run import KINDS

COLOUR = {"stable": "#3a923a", "warned": "#b5cf6b", "refused": "#9ecae1", "stopped": "#fd8d3c", "FAULT": "#d62728"}
# of each sweep: along the map, up the map, one map for each value of
AXES = {"flow": (("tau", r"$\tau$"), ("Ma", "Ma of the water that enters"), ("collision",)),
        "contact": (("every", r"granular steps per fluid step; $k_n \propto$ its square"),
                    ("contact", "time steps per contact"), ("rho", "e")),
        "free": (("ratio", r"$\rho_s/\rho$"), ("r", r"$r/\Delta x$"), ("coupling",)),
        "crowd": (("ratio", r"$\rho_s/\rho$"), ("tau", r"$\tau$"), ("coupling", "average")),
        "crowd2d": (("ratio", r"$\rho_s/\rho$"), ("tau", r"$\tau$"), ("coupling", "r")),
        "column": (("tau", r"$\tau$"), ("excess", r"$\Delta p/\rho c_s^2$"), ("ramp",)),
        "pair": (("gap", r"gap$/\Delta x$"), ("mode", ""), ()),
        "dense": (("phi", "solid fraction"), ("cells", "cells per period"), ()),
        "mixed": (("size", "large over small diameter"), ("every", "granular steps per fluid step"), ())}


def values(results, name):
    found = {case.variables[name] for case, _ in results}
    return sorted(found) if not any(isinstance(x, str) for x in found) else list(dict.fromkeys(
        case.variables[name] for case, _ in results))


def one_map(axes, results, along, up, title):
    xs, ys = values(results, along[0]), values(results, up[0])
    for case, result in results:
        x, y = xs.index(case.variables[along[0]]), ys.index(case.variables[up[0]])
        axes.add_patch(plt.Rectangle((x - 0.48, y - 0.46), 0.96, 0.92, color=COLOUR[result.kind]))
    axes.set_xlim(-0.6, len(xs) - 0.4)
    axes.set_ylim(-0.6, len(ys) - 0.4)
    axes.set_xticks(range(len(xs)), [f"{x:g}" for x in xs], rotation=60 if len(xs) > 8 else 0, fontsize=8)
    axes.set_yticks(range(len(ys)), [y if isinstance(y, str) else f"{y:g}" for y in ys], fontsize=8)
    axes.set_xlabel(along[1], fontsize=9)
    axes.set_ylabel(up[1], fontsize=9)
    axes.set_title(title, fontsize=9)


def sweep(group, results, folder):
    along, up, split = AXES[group]
    parts = {}
    for case, result in results:
        parts.setdefault(tuple(case.variables[name] for name in split), []).append((case, result))
    figure, axes = plt.subplots(1, len(parts), figsize=(1.2 + 4.2 * len(parts), 3.6), squeeze=False)
    for ax, (key, part) in zip(axes[0], parts.items()):
        one_map(ax, part, along, up, ", ".join(f"{n} {v}" for n, v in zip(split, key)))
    shown = [k for k in KINDS if any(r.kind == k for _, r in results)]
    figure.legend(handles=[Patch(color=COLOUR[k], label=k) for k in shown], loc="upper center", ncol=len(shown),
                  fontsize=9, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.92))
    figure.savefig(folder / f"stability_{group}.png", dpi=90)
    plt.close(figure)


def table(results):
    lines = ["| case | wanted | found | command |", "| --- | --- | --- | --- |"]
    for case, result in results:
        if case.group == "rows":
            ranks = f", {case.ranks} ranks" if case.ranks > 1 else ""
            found = result.kind + (": " + textwrap.shorten(result.why, 170, placeholder=" ...") if result.why else "")
            cells = [case.title + ranks, case.want or "right, refused or stopped", found, f"`{case.command()}`"]
            lines.append("| " + " | ".join(cell.replace("|", "/") for cell in cells) + " |")
    return "\n".join(lines)


def draw(results, folder):
    for group in AXES:
        part = [(c, r) for c, r in results if c.group == group]
        if part and plt:
            sweep(group, part, folder)
    if any(case.group == "rows" for case, _ in results):
        (folder / "rows.md").write_text(table(results) + "\n")
