#!/usr/bin/env python3
"""Adds the pages of this package to LAMMPS's manual: join_manual.py LAMMPS/doc/src

Copies doc/src/*.rst and names them in the manual's lists of commands, styles and packages, where
LAMMPS's checks look for them. What a page documents is read from its ".. index::" lines. Twice does no
harm.
"""
import pathlib
import re
import shutil
import sys

OURS = pathlib.Path(__file__).resolve().parent / "src"
# kind in the index: lists of the manual, with the words after the name
LISTS = {"fix": (("Commands_fix.rst", ""), ("fix.rst", " - part of package LBM-IBB")),
         "compute": (("Commands_compute.rst", ""), ("compute.rst", " - part of package LBM-IBB")),
         "pair_style": (("Commands_pair.rst", ""), ("pair_style.rst", " - part of package LBM-IBB")),
         "dump": (("Commands_dump.rst", ""),),
         "": (("Commands_all.rst", ""),)}

LIST_ENTRY = """   * - :ref:`LBM-IBB <PKG-LBM-IBB>`
     - lattice Boltzmann fluid with resolved grains
     - :doc:`Howto lbm_ibb <Howto_lbm_ibb>`
     - ``PACKAGES/lbm_ibb``
     - ext
"""
DETAILS = """.. _PKG-LBM-IBB:

LBM-IBB package
---------------

**Contents:**

A lattice Boltzmann fluid whose moving boundaries are the grains of a granular simulation, by interpolated
bounce-back, and a contact law.

**Install:**

See :doc:`Build_lbm_ibb <Build_lbm_ibb>`.

**Supporting info:**

* ``src/LBM-IBB``: filenames -> commands
* ``src/LBM-IBB/README``
* :doc:`Howto lbm_ibb <Howto_lbm_ibb>`
* :doc:`fix lb/ibb <fix_lb_ibb>`

----------

"""


def edit(path, change):
    text = path.read_text()
    new = change(text)
    if new == text:
        sys.exit(f"join_manual.py: found no place in {path.name}")
    path.write_text(new)


def add_entry(path, name, page, words):
    """before the first entry that comes later in the alphabet, or after the last"""
    lines = path.read_text().split("\n")
    if any(f"`{name} <{page}>`" in line for line in lines):
        return
    entry = re.compile(r"^( *)\* :doc:`([^ <]+)")
    found = [(k, m) for k, m in enumerate(map(entry.match, lines)) if m]
    if not found:
        sys.exit(f"join_manual.py: no list in {path.name}")
    k, m = next(((k, m) for k, m in found if m.group(2) > name), (found[-1][0] + 1, found[-1][1]))
    lines.insert(k, f"{m.group(1)}* :doc:`{name} <{page}>`{words}")
    path.write_text("\n".join(lines))


def main(manual):
    manual = pathlib.Path(manual)
    for page in sorted(OURS.glob("*.rst")):
        shutil.copy(page, manual)
        for index in re.findall(r"^\.\. index:: (.+)$", page.read_text(), re.M):
            kind, _, name = index.rpartition(" ")
            for file, words in LISTS[kind]:
                add_entry(manual / file, name, page.stem, words)
        if page.stem.startswith("Howto_") or page.stem.startswith("Build_"):
            after = {"H": "Howto_granular", "B": "Build_extras"}[page.stem[0]]
            toc = manual / f"{page.stem.split('_')[0]}.rst"
            if f"   {page.stem}\n" not in toc.read_text():
                edit(toc, lambda text: text.replace(f"   {after}\n", f"   {after}\n   {page.stem}\n", 1))
    if "PKG-LBM-IBB" not in (manual / "Packages_list.rst").read_text():
        edit(manual / "Packages_list.rst",
             lambda text: text.replace("   * - :ref:`LEPTON", LIST_ENTRY + "   * - :ref:`LEPTON", 1))
        edit(manual / "Packages_details.rst",
             lambda text: text.replace("   * :ref:`LEPTON <", "   * :ref:`LBM-IBB <PKG-LBM-IBB>`\n   * :ref:`LEPTON <", 1)
             .replace(".. _PKG-LEPTON:", DETAILS + ".. _PKG-LEPTON:", 1))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
