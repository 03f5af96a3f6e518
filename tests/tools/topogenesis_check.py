"""Reads our lattices with topoGenesis's own reader and compares our cube ids with its boolean_marching_cubes().

    python topogenesis_check.py FOLDER

FOLDER/house/lattices/ holds what `houscaper build` wrote; FOLDER/random/<n>.csv random lattices and <n>-ids.csv what
`houscaper cubes --scheme topogenesis` made of them; FOLDER/arrays/<name>.npy and .csv the same arrays by `houscaper convert`.
Needs topogenesis (PyPI) with scipy and pyvista beside it. Exit code 1 at the first difference, 3 where it is missing.
"""

import json
import pathlib
import sys

try:
    import numpy as np
    import topogenesis as tg
except ImportError as missing:
    print(missing)
    sys.exit(3)

folder = pathlib.Path(sys.argv[1])


def need(holds, *what):
    if not holds:
        print("FAILED:", *what)
        sys.exit(1)


def padded_ids(lattice):
    """Ids of the cubes of the lattice padded by one empty layer: how its users close a body before marching."""
    # The pad is made by hand, so that it does not rest on anything of ours.
    occupied = np.zeros(np.array(lattice.shape) + 2, dtype=int)
    occupied[1:-1, 1:-1, 1:-1] = np.asarray(lattice) > 0
    padded = tg.to_lattice(occupied, minbound=lattice.minbound - lattice.unit, unit=lattice.unit)
    return padded.boolean_marching_cubes()


house = folder / "house" / "lattices"
about = json.loads((house / "lattices.json").read_text())
size = np.array(about["module_size"])
voxels = tg.lattice_from_csv(house / "voxels.csv")
ids = padded_ids(voxels)
need(np.allclose(voxels.unit, size), "unit", voxels.unit)
for entry in about["lattices"]:
    lattice = tg.lattice_from_csv(house / entry["file"])
    is_cube = entry["cells"] == "cube"
    need(lattice.shape == tuple(n + is_cube for n in voxels.shape), entry["file"], lattice.shape)
    need(np.allclose(lattice.unit, size), entry["file"], lattice.unit)
    # Cubes stand where topoGenesis puts its own.
    need(np.allclose(lattice.minbound, ids.minbound if is_cube else voxels.minbound, atol=1e-6), entry["file"], lattice.minbound)
    need(np.isfinite(np.asarray(lattice, dtype=float)).all(), entry["file"], "holds values that are not finite")
    print(f"{entry['file']}: {lattice.shape} {np.asarray(lattice).dtype} {np.min(lattice)} to {np.max(lattice)}")
ours = tg.lattice_from_csv(house / "topogenesis_ids.csv")
need(np.array_equal(ours, ids), "the house's ids differ")
tiles = tg.lattice_from_csv(house / "tile_ids.csv")
surface = (np.asarray(ids) > 0) & (np.asarray(ids) < 255)
need(((np.asarray(tiles) > 0) | ~surface).all(), "a cube of the surface has no tile")

cells = 0
lattices = sorted(path for path in (folder / "random").glob("*.csv") if not path.stem.endswith("-ids"))
for path in lattices:
    lattice = tg.lattice_from_csv(path)
    theirs = padded_ids(lattice)
    ours = tg.lattice_from_csv(path.with_name(f"{path.stem}-ids.csv"))
    need(ours.shape == theirs.shape, path.name, ours.shape, theirs.shape)
    need(np.array_equal(ours, theirs), path.name, "differs in", int(np.sum(np.asarray(ours) != np.asarray(theirs))), "cells")
    cells += theirs.size
print(f"{len(lattices)} lattices, {cells} cubes: ids equal boolean_marching_cubes() cell by cell")

arrays = sorted((folder / "arrays").glob("*.npy"))
for path in arrays:
    array = np.load(path)
    lattice = tg.lattice_from_csv(path.with_suffix(".csv"))
    need(np.array_equal(array, np.asarray(lattice)) and array.shape == lattice.shape, path.name, "differs from its CSV")
    again = path.with_suffix(".again")
    with open(again, "wb") as file:
        np.save(file, np.ascontiguousarray(array))
    need(again.read_bytes() == path.read_bytes(), path.name, "is not what numpy.save writes")
print(f"{len(arrays)} arrays: numpy reads them, saves the same bytes, and they equal their CSV")
