#!/usr/bin/env python3
"""What ./run accuracy keeps, and what it makes of its numbers: python3 accuracy.py ROOT; needs LMP and LBMIBB_BUILD,
runs nothing."""
import importlib.machinery
import importlib.util
import pathlib
import sys

tools = pathlib.Path(sys.argv[1]) / "tools"
sys.path.insert(0, str(tools))
loader = importlib.machinery.SourceFileLoader("sweep", str(tools / "accuracy"))
sweep = importlib.util.module_from_spec(importlib.util.spec_from_loader("sweep", loader))
loader.exec_module(sweep)
tables, cases = sweep.accuracy_tables, sweep.accuracy_cases


def row(r, value, case="array_0.125", **other):
    return {**dict.fromkeys(sweep.COLUMNS, ""), **sweep.accuracy_tables.DEFAULT, "case": case, "quantity": "drag", "sweep": "dx",
            "r_over_dx": str(r), "tau": "2", "value": str(value), "reference": "4.292", "node_updates": "1000",
            "error": str(value / 4.292 - 1), **other}


# of the same choice the new row stays, and all old ones that were not found anew
table = sweep.merged([row(3, 4.0), row(7.754, 4.28), row(3, 4.1, link="zhao")], [row(3, 4.2)])
found = sorted((r["r_over_dx"], r["link"], r["value"]) for r in table)
assert found == [("3", "cli", "4.2"), ("3", "zhao", "4.1"), ("7.754", "cli", "4.28")], found

# radii that are known and were not measured anew stay, and none is there twice
known = [line for line in sweep.accuracy_tables.RADII.read_text().splitlines() if line[0] != "#"]
lines = [line for line in tables.radii([row(float(known[0].split()[2]), 4.0)]) if line[0] != "#"]
assert [line.split()[:3] for line in lines] == [line.split()[:3] for line in known], lines

# an error of the lattice and a floor are told apart
points = [(m, (1e-6 + (0.15 * m * m)**2)**0.5) for m in (0.001, 0.003, 0.01, 0.03, 0.1, 0.2)]
(a, b, c), misfit = tables.fit_floor(points)
assert abs(a**0.5 - 1e-3) < 1e-6 and abs(c**0.5 - 0.15) < 1e-4 and misfit < 1e-6, (a, b, c, misfit)
assert tables.fit_floor(points, 1.5)[1] > 0.01 < tables.fit_floor(points, 2.5)[1]

# a rule that is better at the same cost beats the default; a finer default, or a dearer rule, does not
mine = row(3, 4.2)
others = [row(4, 4.28), row(3, 4.28, link="zhao"), row(3, 4.28, link="bouzidi", node_updates="1200")]
assert tables.beaten(mine, [mine, *others]) == [others[1]]

# the default before its rivals, and nothing twice
points = [point for name in cases.GROUPS for point in cases.GROUPS[name](False)]
names = [(p.case, p.sweep, f"{p.r:.4g}", f"{p.tau:.4g}", tuple(sorted(p.choice.items()))) for p in points]
assert len(set(names)) == len(names), sorted(n for n in names if names.count(n) > 1)
assert all(p.importance() == 0 for p in points if p.sweep == "dx" and not p.choice)
print("ok", len(points), "points")
