"""Tables of ./run accuracy: what settings reach an error, where the default stands, at what order errors fall."""
import math

from accuracy_run import DEFAULT, RADII

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
    return [row for row in table if row["case"] == case and row["quantity"] == MAIN.get(case, "drag")
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
    """rows of other rules that are better than this one by more than 10 %: in error and not dearer by as much, or in
    cost and not worse; another resolution or tau of the default is no other choice"""
    mine, paid = error(row), number(row, cost)
    return [o for o in rows if not is_default(o) and
            ((error(o) * by < mine and number(o, cost) <= by * paid) or (error(o) <= mine and number(o, cost) * by < paid))]


def tuned(row):
    """by a number, Lambda or a table of radii, and not by a rule"""
    return row["radius"] != "given" or row["collision"].startswith("trt ")


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


def losses(table, case, numbers):
    """points of the default, of all tau, that no other of its points beats, and by which rows those are beaten: other
    rules, or numbers too"""
    rows = [row for row in of(table, case) if numbers or not tuned(row)]
    best = front([row for row in rows if is_default(row)], "node_updates")
    return best, [(row, others) for row in best if (others := beaten(row, rows))]


def on_front(table, numbers):
    """cases, and those in which nothing beats the default by more than 10 %"""
    cases = [case for case in MAIN if any(not is_default(row) and not tuned(row) for row in of(table, case)) and
             any(is_default(row) for row in of(table, case))]
    return cases, [case for case in cases if not losses(table, case, numbers)[1]]


def standing(table):
    """is the default on the front, within 10 % of error or of cost; where not, what to take"""
    cases, rules = on_front(table, False)
    _, numbers = on_front(table, True)
    lines = [f"No other rule is better than the default by more than 10 % in {len(rules)} of {len(cases)} cases; nor another "
             f"Lambda or *radius calibrated* in {len(numbers)}.", "",
             "| case | points of the default | beaten by a rule | by a number | where, and what to take there |",
             "| --- | --- | --- | --- | --- |"]
    for case in cases:
        best, lost = losses(table, case, True)
        words = []
        for row, others in lost:
            other = min(others, key=error)
            words.append(f"r = {number(row, 'r_over_dx'):.3g}, tau {row['tau']}, {100 * error(row):.2g} %: {rule(other)}"
                         f"{'' if other['tau'] == row['tau'] else ' tau ' + other['tau']}, {100 * error(other):.2g} %")
        by_rules = len(losses(table, case, False)[1])
        lines.append(f"| {case} | {len(best)} | {by_rules} | {sum(any(map(tuned, others)) for _, others in lost)} | "
                     f"{'; '.join(words) or '-'} |")
    return lines


# ---- what is left of the error of vortices on a lattice as the time step grows: Ma^2

def solve(A, b):
    """A x = b, by elimination"""
    rows, n = [[*row, value] for row, value in zip(A, b)], len(b)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(n):
            if i != k:
                rows[i] = [x - rows[i][k] / rows[k][k] * y for x, y in zip(rows[i], rows[k])]
    return [row[n] / row[k] for k, row in enumerate(rows)]


def fit_floor(points, p=2.0):
    """a, b, c of error^2 = a + b Ma^p + c Ma^2p through points (Ma, error), relative misfit: two errors, of the lattice
    and a floor sqrt(c) Ma^p, of different shapes"""
    terms = [[m**(k * p) / e**2 for k in range(3)] for m, e in points]
    A = [[sum(t[i] * t[j] for t in terms) for j in range(3)] for i in range(3)]
    found = solve(A, [sum(t[i] for t in terms) for i in range(3)])
    misfit = [sum(x * t for x, t in zip(found, row)) - 1 for row in terms]
    return found, math.sqrt(sum(m * m for m in misfit) / len(points))


def floors(table):
    """by nodes to the period: (Ma, error), fit with Ma^2, and the power that fits best"""
    rows = [row for row in of(table, "taylor_green") if is_default(row)]
    found = {}
    for n in sorted({2 * number(row, "r_over_dx") for row in rows}):
        points = sorted((math.sqrt(3) * 30 * (number(row, "tau") - 0.5) / 3 / n, error(row)) for row in rows
                        if 2 * number(row, "r_over_dx") == n)
        if len(points) < 6 or points[-1][0] < 0.1:
            continue
        power = min((k / 20 for k in range(20, 61)), key=lambda p: fit_floor(points, p)[1])
        found[n] = (points, *fit_floor(points), power)
    return found


def floor_lines(table):
    lines = ["| nodes to the period | tau | Ma | error without floor | floor over Ma^2 | misfit | best power of Ma |",
             "| --- | --- | --- | --- | --- | --- | --- |"]
    for n, (points, (a, _, c), misfit, power) in floors(table).items():
        tau = lambda m: 0.5 + m * n / 10 / math.sqrt(3)
        lines.append(f"| {n:.0f} | {tau(points[0][0]):.3g} to {tau(points[-1][0]):.3g} | {points[0][0]:.2g} to "
                     f"{points[-1][0]:.2g} | {100 * math.sqrt(max(a, 0)):.2g} % | {math.sqrt(max(c, 0)):.3g} | "
                     f"{100 * misfit:.2g} % | {power:.2g} |")
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
    for phi in ("0.125", "0.45"):
        fixed = {r["r_over_dx"]: number(r, "value") for r in refinement(table, f"array_{phi}")}
        apart = [abs(number(r, "value") / fixed[r["r_over_dx"]] - 1) for r in refinement(table, f"moving_array_{phi}")
                 if r["r_over_dx"] in fixed and number(r, "r_over_dx") > 4]    # coarser, 8 places are too few for .01
        if apart:
            found.append((f"drag of the moving cubic array at {phi} against that of the fixed one", max(apart), 0.01))
    found += [("force on the sphere between plates, r = 3.08, radius calibrated", abs(number(r, "error")), 0.01)
              for r in of(table, "plates") if abs(number(r, "r_over_dx") - 3.08) < 0.01 and rule(r) == "calibrated"]
    for case, what in (("array_0.125", "drag of the array"), ("bed", "permeability of the bed")):
        varied = [r for r in of(table, case) if r["sweep"] == "tau" and is_default(r) and number(r, "tau") <= 1.5]
        if len(varied) > 1:
            values = [number(r, "value") for r in varied]
            found.append((f"{what}, range over tau from {varied[0]['tau']} to {varied[-1]['tau']}",
                          max(values) / min(values) - 1, 0.001))
    cases, kept = on_front(table, False)
    if len(cases) > 4:
        found.append(("share of cases in which a rule beats the default by more than 10 %", 1 - len(kept) / len(cases), 0.2))
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
    # what is there and was not found anew stays
    known = RADII.read_text().splitlines() if RADII.exists() else []
    lines += [line for line in known if line[:1] not in ("", "#") and tuple(line.split()[:3]) not in done]
    return lines[:4] + sorted(lines[4:], key=lambda line: [*line.split()[:2], float(line.split()[2])])


def write(table, out):
    parts = [("To reach", gate_lines), ("Settings", settings), ("Orders", orders), ("The default", standing), ("Floor", floor_lines),
             ("Everything", everything)]
    text = "\n\n".join("\n".join([f"## {title}", "", *make(table)]) for title, make in parts)
    (out / "tables.md").write_text(text + "\n")
    (out / "lbm-ibb.accuracy").write_text("\n".join(for_the_plan(table)) + "\n")
    if len(refinement(table, "array_0.125")) > 4:
        (out / "lbm-ibb.radius").write_text("\n".join(radii(table)) + "\n")
