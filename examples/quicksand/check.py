"""What the runs of figure.sh said, as results.txt: name value low high"""
import glob
import re

RHO, BOX = 1000.0, 2.4e-3 * 2.4e-3 * 7.2e-3    # of 100 grains; of 400 the section is four times as large
BEGIN, END, NEAR = 0.048, 0.072, 0.004         # window of the mean, and seconds for the flux at its ends


def water_slows(run, wide):
    """share of dp S that a bed on its way gets from water that slows down, in the mean over the window"""
    rows = [[float(x) for x in line.split()] for line in open(f"{run}.dat") if line[0] != "#"]

    def flux(t):
        near = [r[6] for r in rows if abs(r[0] - t) < NEAR]
        return sum(near) / len(near)

    weight = float(re.search(r"submerged weight (\S+) N", open(f"{run}.txt").read()).group(1))
    ratio = next(r[1] for r in rows if r[0] > BEGIN)
    loss = RHO * BOX * (4 if wide else 1) * (flux(BEGIN) - flux(END))
    return loss / (END - BEGIN) / (ratio * weight)


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
        results.append((f"carried_{run}", carried, "-", "-"))
        balance = float(carried) - water_slows(run, run.startswith("wide"))
        results.append((f"carried_but_for_slowing_water_{run}", f"{balance:.5f}", 0.9996, 1.0004))
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
