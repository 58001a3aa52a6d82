#!/usr/bin/env python3
"""python3 check.py: a plug made of a region against the same made of grains, and sand on it, into results.txt

Reads porous_plug.dat as in.porous_plug writes it: solid, conserve, flux, force, links, force over driving; or sand, grains,
lowest of them in cells, mean speed, flux.
"""


def main():
    with open("porous_plug.dat") as file:
        rows = [line.split() for line in file]
    plug = {(r[0], r[1]): [float(x) for x in r[2:]] for r in rows if r[0] != "sand"}
    sand = [[float(x) for x in r[1:]] for r in rows if r[0] == "sand"][-1]
    area, L, p, mu = 24e-4 ** 2, 55e-4, 0.05, 1e-3
    with open("results.txt", "w") as out:
        for conserve, limit in ("yes", 1e-3), ("no", 1e-9):
            region, grains = plug["region", conserve], plug["grains", conserve]
            print(f"permeability_conserve_{conserve}_m2 {mu * region[0] * L / p:.6e} - -", file=out)
            for k, what in enumerate(("flux", "force", "links")):
                print(f"{what}_region_over_grains-1_conserve_{conserve} {region[k] / grains[k] - 1:.2e} {-limit:g} {limit:g}", file=out)
            # the water between the faces is driven by p on the whole section, and held by the plug alone
            print(f"force_over_driving_conserve_{conserve} {region[3]:.6f} 0.99 1.01", file=out)
        print(f"sand_grains {sand[0]:.0f} 18 18", file=out)
        print(f"sand_lowest_cells {sand[1]:.3f} 24 -", file=out)
        print(f"sand_speed_m/s {sand[2]:.1e} 0 2e-3", file=out)
    print(open("results.txt").read(), end="")


main()
