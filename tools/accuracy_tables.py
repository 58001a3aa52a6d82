"""Tables of ./run accuracy: what settings reach an error, where the default stands, at what order errors fall."""
import math

from accuracy_run import DEFAULT

CASES_3D = ("array_0.125", "array_0.45", "plates", "moving", "settling_E3", "settling_E1", "bed")
MAIN = {"array_0.125": "drag", "array_0.45": "drag", "plates": "drag", "moving": "moving_rms",
        "settling_E1": "settling_E1", "settling_E3": "settling_E3", "bed": "permeability", "taylor_green": "velocity",
        "womersley": "velocity"}


def number(row, name):
    try:
        return float(row[name])
    except ValueError:
        return math.nan


def error(row):
    """root mean square of what one place of the grain, unknown, gets: bias and scatter together"""
    scatter = number(row, "scatter")
    return math.hypot(number(row, "error"), 0.0 if math.isnan(scatter) else scatter)


def of(table, case):
    return [row for row in table if row["case"] == case and row["quantity"] == MAIN[case]
            and not math.isnan(error(row))]


def is_default(row):
    return all(row[name] == value for name, value in DEFAULT.items())


def rule(row):
    """what is not the default, in words"""
    return " ".join(row[name] for name, value in DEFAULT.items() if row[name] != value) or "default"


def refinement(table, case):
    """the default, coarse to fine"""
    return sorted((row for row in of(table, case) if row["sweep"] == "dx" and is_default(row)),
                  key=lambda row: float(row["r_over_dx"]))


def slope(points):
    """least squares of log y against log x, of (x, y)"""
    points = [(math.log(x), math.log(y)) for x, y in points if x > 0 and y > 0]
    if len(points) < 2:
        return math.nan
    mx, my = (sum(p[k] for p in points) / len(points) for k in (0, 1))
    return sum((x - mx) * (y - my) for x, y in points) / sum((x - mx)**2 for x, _ in points)


def front(rows, cost):
    """those that no other beats in both error and cost, cheapest first"""
    best, kept = math.inf, []
    for row in sorted(rows, key=lambda r: (number(r, cost), error(r))):
        if error(row) < best:
            best = error(row)
            kept.append(row)
    return kept


def beaten(row, rows, cost="node_updates", by=1.1):
    """rows that are better in both by more than 10 %, and not of the same rules: another resolution of the default
    is no other choice"""
    return [other for other in rows if not is_default(other) and error(other) * by < error(row)
            and number(other, cost) * by < number(row, cost)]


def settings(table):
    """coarsest default that stays within an error, and what it costs"""
    lines = ["| case | " + " | ".join(f"{100 * e:g} %" for e in (0.05, 0.02, 0.01, 0.005)) + " |",
             "| --- | --- | --- | --- | --- |"]
    for case in CASES_3D:
        rows = refinement(table, case)
        cells = []
        for wanted in (0.05, 0.02, 0.01, 0.005):
            good = None
            for row in reversed(rows):    # it and all finer ones
                if error(row) > wanted:
                    break
                good = row
            cells.append("finer than measured" if good is None else
                         f"r = {number(good, 'r_over_dx'):.3g} ({number(good, 'node_updates'):.2g} updates)")
        if rows:
            lines.append(f"| {case} | " + " | ".join(cells) + " |")
    return lines


def orders(table):
    """the finest half of each refinement: order in r/dx, and slope against node updates"""
    lines = ["| case | order in r/dx | slope against cost, theory -2/5 | error from, to |", "| --- | --- | --- | --- |"]
    for case in CASES_3D:
        rows = refinement(table, case)
        if len(rows) < 3:
            continue
        order = -slope([(number(r, "r_over_dx"), error(r)) for r in rows])
        cost = slope([(number(r, "node_updates"), error(r)) for r in rows])
        lines.append(f"| {case} | {order:.2f} | {cost:.2f} | {100 * error(rows[0]):.2f} % at r = "
                     f"{number(rows[0], 'r_over_dx'):.3g}, {100 * error(rows[-1]):.2f} % at "
                     f"{number(rows[-1], 'r_over_dx'):.3g} |")
    return lines


def standing(table):
    """is the default on the front, within 10 %, and what beats it"""
    lines = ["| case | default points | beaten | by |", "| --- | --- | --- | --- |"]
    for case in CASES_3D:
        rows = of(table, case)
        mine = [row for row in rows if is_default(row) and row["sweep"] in ("dx", "tau")]
        best = front(rows, "node_updates")
        lost = [(row, beaten(row, rows)) for row in mine if row["sweep"] == "dx"]
        lost = [(row, others) for row, others in lost if others]
        by = sorted({f"{rule(o)} tau {o['tau']}" for _, others in lost for o in others})
        if mine:
            lines.append(f"| {case} | {sum(r['sweep'] == 'dx' for r in mine)} | {len(lost)} | "
                         f"{', '.join(by[:6]) or '-'}; {sum(map(is_default, best))} of {len(best)} on the front are "
                         "default |")
    return lines


def everything(table):
    """one line for every number"""
    lines = ["| case | quantity | r/dx | tau | rules | error % | scatter % | core s | M updates/s |",
             "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for row in table:
        scatter = number(row, "scatter")
        lines.append(f"| {row['case']} | {row['quantity']} | {number(row, 'r_over_dx'):.3g} | {row['tau']} | "
                     f"{rule(row)} | {100 * number(row, 'error'):.3g} | "
                     f"{'' if math.isnan(scatter) else f'{100 * scatter:.2g}'} | {row['cpu_s']} | {row['mlups']} |")
    return lines


def for_the_plan(table):
    """lbm-ibb.accuracy: what the default's error was, by cells per radius"""
    lines = ["# Errors of fix lb/ibb with its default rules, as ./run accuracy found them (doc/accuracy.md)",
             "# quantity[@fraction of solid] r_over_dx error"]
    for quantity, case in (("drag@0.125", "array_0.125"), ("drag@0.45", "array_0.45"), ("permeability@0.606", "bed"),
                           ("settling", "settling_E3"), ("moving_rms", "moving")):
        for row in refinement(table, case):
            lines.append(f"{quantity} {row['r_over_dx']} {error(row):.4g}")
    return lines


def gates(table):
    """what must hold: (what, found, limit), found above the limit being a failure; of what has been run"""
    found = []
    for cells, limit in ((8, 0.03), (12, 0.01), (20, 0.003)):
        near = [r for r in refinement(table, "array_0.125") if cells <= 2 * number(r, "r_over_dx") < 1.1 * cells]
        found += [(f"drag of the cubic array, {cells} cells per diameter", abs(number(r, "error")), limit) for r in near[:1]]
    found += [("force on the sphere between plates, r = 3.08, radius calibrated", abs(number(r, "error")), 0.01)
              for r in of(table, "plates") if abs(number(r, "r_over_dx") - 3.08) < 0.01 and rule(r) == "calibrated"]
    for case, what in (("array_0.125", "drag of the array"), ("bed", "permeability of the bed")):
        varied = [r for r in of(table, case) if r["sweep"] == "tau" and is_default(r) and number(r, "tau") <= 1.5]
        if len(varied) > 1:
            values = [number(r, "value") for r in varied]
            found.append((f"{what}, range over tau from {varied[0]['tau']} to {varied[-1]['tau']}",
                          max(values) / min(values) - 1, 0.001))
    for case in ("taylor_green", "womersley"):
        rows = [r for r in of(table, case) if r["sweep"] == "dx" and is_default(r) and r["tau"] in ("0.8", "0.55")]
        for tau in sorted({r["tau"] for r in rows}):
            points = [(number(r, "r_over_dx"), error(r)) for r in rows if r["tau"] == tau]
            if len(points) > 1:
                found.append((f"2 less the order of {case}, tau {tau}", 2 + slope(points), 0.1))
    return found


def gate_lines(table):
    return ["| what | found | limit |", "| --- | --- | --- |",
            *(f"| {what} | {'**' if value > limit else ''}{value:.2g}{'**' if value > limit else ''} | {limit:g} |"
              for what, value, limit in gates(table))]


# Zick & Homsy 1982, simple cubic, around 1/8
ARRAYS = {0.064: 2.810, 0.125: 4.292, 0.216: 7.442}


def effective_radius(r, K):
    """of a sphere that is taken for one of radius r in an array of solid fraction 1/8 and gives K: a K(phi) there is
    what was measured, with ln K a parabola of ln phi"""
    x, y = [math.log(phi) for phi in ARRAYS], [math.log(k) for k in ARRAYS.values()]

    def lnK(at):
        return sum(y[i] * math.prod((at - x[j]) / (x[i] - x[j]) for j in range(3) if j != i) for i in range(3))

    low, high = 0.8, 1.25    # of the radius
    for _ in range(60):
        middle = 0.5 * (low + high)
        if math.log(middle) + lnK(math.log(0.125) + 3 * math.log(middle)) < math.log(K):
            low = middle
        else:
            high = middle
    return r * middle


def radii(table):
    """lbm-ibb.radius: what to add to a radius so that the drag is that of the sphere meant"""
    lines = ["# Radii of spheres in cells, and what to add to them: fix lb/ibb keyword radius calibrated. From the mean",
             "# drag of simple cubic arrays of solid fraction 1/8 over 8 places on the lattice, collision trt, against",
             "# Zick & Homsy 1982: written by ./run accuracy (doc/accuracy.md)", "# link tau r correction"]
    rows = [row for row in of(table, "array_0.125") if row["collision"] == "trt" and row["precision"] == "double"
            and row["radius"] == "given"]
    done = set()
    sizes = {}    # a rule at one tau needs three radii
    for row in rows:
        sizes.setdefault((row["link"], row["tau"]), set()).add(row["r_over_dx"])
    rows = [row for row in rows if len(sizes[row["link"], row["tau"]]) > 2]
    for row in sorted(rows, key=lambda row: (row["link"], number(row, "tau"), number(row, "r_over_dx"))):
        viscosity = "any" if row["link"] == "cli" else row["tau"]
        key = (row["link"], viscosity, row["r_over_dx"])
        if key in done or (viscosity == "any" and row["sweep"] != "dx"):
            continue
        done.add(key)
        r = number(row, "r_over_dx")
        lines.append(f"{' '.join(key)} {r - effective_radius(r, number(row, 'value')):.5f}")
    return lines


def write(table, out):
    parts = [("To reach", gate_lines), ("Settings", settings), ("Orders", orders), ("The default", standing), ("Everything", everything)]
    text = "\n\n".join("\n".join([f"## {title}", "", *make(table)]) for title, make in parts)
    (out / "tables.md").write_text(text + "\n")
    (out / "lbm-ibb.accuracy").write_text("\n".join(for_the_plan(table)) + "\n")
    if len(refinement(table, "array_0.125")) > 4:
        (out / "lbm-ibb.radius").write_text("\n".join(radii(table)) + "\n")
