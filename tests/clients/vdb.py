#!/usr/bin/env python3
"""Volumes as OpenVDB's own library reads them, against the particles that they were made of.

    /usr/bin/python3 tests/clients/vdb.py build/release/bin/fumage-cli

Needs python3-openvdb, libopenvdb-tools and python3-numpy; half a minute.
"""
import json
import pathlib
import sys
import tempfile

import numpy as np
import pyopenvdb as vdb

from smoke import mass, particles, run

PRESETS = {"plume": {"density", "vel", "temperature"}, "campfire": {"density", "vel", "temperature", "flames"}, "thesis-2012": {"density", "vel"}}
FEWER = ["--set", "emitter.count=20000"]


def values(grid):
    return np.array([each.value for each in grid.citerOnValues()])


def check(cli, folder, preset, up):
    path = folder / f"{preset}-{up}.vdb"
    run(cli, "volume", preset, "--frame", 40, "--cells", 96, "--up", up, "--output", path, *FEWER)
    grids = {grid.name: grid for grid in vdb.readAll(str(path))[0]}
    wanted = PRESETS[preset]
    assert set(grids) == wanted, set(grids)
    smoke = particles(cli, preset, 40, up, FEWER)
    weight = mass(smoke)
    density = grids["density"]
    cell = density.transform.voxelSize()[0]
    extinction = values(density)
    whole = extinction.sum() * cell**3 / weight.sum()
    assert abs(whole - 1) < 2e-3, whole  # half floats
    # Where the smoke is, and how fast, weighted by how much of it there is.
    places = np.array([density.transform.indexToWorld(each.min) for each in density.citerOnValues()])
    middle = (places * extinction[:, None]).sum(0) / extinction.sum()
    expected = np.array([(smoke[axis] * weight).sum() for axis in "xyz"]) / weight.sum()
    assert np.abs(middle - expected).max() < 0.05 * cell, (middle, expected, cell)
    velocity = (values(grids["vel"]) * extinction[:, None]).sum(0) / extinction.sum()
    expected = np.array([(smoke["v" + axis] * weight).sum() for axis in "xyz"]) / weight.sum()
    assert np.abs(velocity - expected).max() < 5e-3, (velocity, expected)
    if "temperature" in grids:
        heat = values(grids["temperature"])
        cooling = json.loads(run(cli, "presets", "--show", preset))["layers"][0]["glow"]["emission_cooling"]
        glow = smoke["heat"] * np.exp(-cooling * smoke["age"])  # the heat of the air, and what fire has lost since
        assert 0 <= heat.min() and heat.max() <= glow.max() * 1.001, (heat.min(), heat.max())
        expected = (glow * weight).sum() / weight.sum()
        assert abs((heat * extinction).sum() / extinction.sum() - expected) < 5e-3, expected
    if "flames" in grids:
        flames = values(grids["flames"])
        assert 0 < flames.max() and (flames <= extinction * 1.01 + 1e-3).all()
    for grid in grids.values():
        assert grid.metadata["is_saved_as_half_float"]
        assert grid.activeVoxelCount() == density.activeVoxelCount()
        assert grid.metadata["file_bbox_min"] == grid.evalActiveVoxelBoundingBox()[0]
        assert grid.metadata["file_bbox_max"] == grid.evalActiveVoxelBoundingBox()[1]
    assert density.gridClass == "fog volume"
    assert "density" in run("vdb_print", path)
    print(f"{preset}, {up} up: {density.activeVoxelCount()} voxels of {cell:.4f} m, {path.stat().st_size / 2**20:.1f} MiB, smoke {whole:.5f} of what particles hold")


def check_sequence(cli, folder):
    """Frames of a burst, the last without smoke, have the same grids in the same places, also where they are written apart."""
    burst = ["--set", "emitter.mode=burst", "--set", "emitter.count=500", "--set", "life.fade_rate=2", "--set", "glow.emission=3", "--set", "timeline.length=60"]
    run(cli, "volume", "thesis-2012", "--frames", "0-50:10", "--cells", 32, "--output", folder / "whole_##.vdb", *burst)
    run(cli, "volume", "thesis-2012", "--frame", 50, "--cells", 32, "--output", folder / "apart_50.vdb", *burst)
    assert (folder / "whole_50.vdb").read_bytes() == (folder / "apart_50.vdb").read_bytes()
    seen = set()
    for number in range(0, 60, 10):
        grids = vdb.readAll(str(folder / f"whole_{number:02}.vdb"))[0]
        seen.add(tuple(sorted((grid.name, grid.transform.voxelSize(), grid.transform.indexToWorld((0, 0, 0))) for grid in grids)))
    assert len(seen) == 1 and len(seen.pop()) == 4, seen
    assert not any(True for _ in grids[0].citerOnValues())
    print("a sequence: the same grids in the same voxels, with smoke and without")


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_sequence(sys.argv[1], pathlib.Path(folder))
        for preset in PRESETS:
            for up in "zy":
                check(sys.argv[1], pathlib.Path(folder), preset, up)


if __name__ == "__main__":
    main()
