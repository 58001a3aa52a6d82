"""What the runs of figure.sh said, as results.txt: name value low high"""
import glob
import re

results, table = [], []
for name in sorted(glob.glob("*.txt")):
    if name.endswith(("deposit.txt", "results.txt")):
        continue
    text = open(name).read()
    run = name[:-len(".txt")]
    steady = re.search(r"sum F_z/\(dp S\) = (\S+), bed height \S+ mm, porosity (\S+),", text)
    onset = re.search(r"^quicksand onset i/ic = (\S+)", text, re.M)
    held = re.search(r"^quicksand held i/ic = (\S+) .*: bed (\w+)", text, re.M)
    if onset:
        carried, porosity = steady.groups()
        results.append((f"onset_{run}", onset.group(1), 0.85, 1.03))
        results.append((f"carried_{run}", carried, 0.999, 1.001))
        table.append((run, onset.group(1), porosity))
    if held and held.group(2) == "moved":
        results.append(("lowest_gradient_that_triggers", held.group(1), 0.90, 1.00))
    elif held:
        results.append((f"still_at_{run}", held.group(1), "-", "-"))

with open("results.txt", "w") as file:
    for result in results:
        print(*result, file=file)
with open("onset.dat", "w") as file:
    print("# run onset_i/ic porosity", file=file)
    for row in table:
        print(*row, file=file)
