"""The roofline of ./run bench: operations a second against operations a byte, with what the machine allows."""

LINK_FLOPS = 90    # CLI, moving: coefficients, velocity of the wall, momentum, torque
LINK_BYTES = 12    # of its list; what else it touches is in the cache
LINKS = {8.4: 1.22, 5.3: 1.92}    # a node, phi = .6


def intensities(flops_3d, flops_2d):
    """operations and bytes a node that have to be, by the rows of the table"""
    bed = lambda r: (0.4 * flops_3d + LINK_FLOPS * LINKS[r], 304.0 + LINK_BYTES * LINKS[r])
    return {"fluid alone, double / limit": (flops_3d, 304.0),
            "fluid alone, single / twice the limit": (flops_3d, 152.0),
            "fluid alone, D2Q9 / its limit": (flops_2d, 144.0),
            "moving bed, r = 8.4 / limit": bed(8.4),
            "moving bed, r = 5.3 / limit": bed(5.3),
            "frozen bed, r = 8.4 / limit": bed(8.4)}


def draw(speeds, top, peak, picture):
    """speeds: M nodes/s by row, as they are at the limit top, in M nodes/s; peak: (10^9 operations/s, operations a node)"""
    try:
        import matplotlib
    except ImportError:
        return "no picture: this python3 has no matplotlib"
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, ax = pyplot.subplots(figsize=(8, 5))
    x = [0.1 * 1.1**k for k in range(60)]
    memory = top * 304e-3    # GB/s
    ax.loglog(x, [min(memory * v, peak[0]) for v in x], "k-")
    ax.text(0.12, memory * 0.17, f"memory, in place: {memory:.0f} GB/s", rotation=32, rotation_mode="anchor")
    ax.text(19, peak[0] * 1.1, f"{peak[0]:.0f} Gflop/s, double precision", ha="right")
    for k, (row, (flops, moved)) in enumerate(intensities(*peak[1:]).items()):
        if row in speeds:
            label = f"{row.split(' /')[0]}: {speeds[row]:.0f} M nodes/s"
            ax.plot([flops / moved], [flops * speeds[row] * 1e-3], "osD^v<"[k], label=label)
    ax.set(xlabel="operations a byte that has to move", ylabel="10$^9$ operations/s", xlim=(0.1, 20),
           ylim=(None, peak[0] * 1.6))
    ax.legend(loc="lower right", title=f"where the limit is {top:.0f} M nodes/s")
    figure.tight_layout()
    figure.savefig(picture, dpi=120)
    return f"picture: {picture}"
