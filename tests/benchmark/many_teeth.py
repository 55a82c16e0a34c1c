"""What a batch costs beyond its teeth: many_teeth.py PROGRAM [COUNT] (200), with PYTHONPATH=build/release/python.

COUNT made-up teeth, every one another (kind, spacings, size), one of them damaged. Told are the seconds of the batch by the clock and of its processes, by the clock and on processors, the largest
process, and the seconds of the same call again, which has nothing left to do but the damaged one.
"""
import json
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
import time

import odontoscope

program, count = pathlib.Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 200


def made_up(chance):
    rows = odontoscope.sample(chance.choice(["incisor", "premolar"]), slice_spacing=chance.uniform(0.3, 0.35), point_spacing=chance.uniform(0.5, 0.7))
    size = chance.uniform(0.9, 1.1)
    return odontoscope.Contours([(z * size, points * size, structure) for z, row in zip(rows.heights, rows) for structure, points in row])


def batch(folder):
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    done = subprocess.run([program, "--quiet", "batch", "teeth/*.json", "-o", "models", "--format", ".glb"], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done.returncode, time.monotonic() - start, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


with tempfile.TemporaryDirectory() as kept:
    folder = pathlib.Path(kept)
    (folder / "teeth").mkdir()
    chance = random.Random(1)
    for n in range(count):
        made_up(chance).save(folder / f"teeth/tooth-{n:03}.json")
    damaged = folder / f"teeth/tooth-{count // 2:03}.json"
    damaged.write_bytes(damaged.read_bytes()[:5000])
    code, wall, processors = batch(folder)
    report = json.loads((folder / "models/batch.json").read_text())
    items = report["items"]
    alone = sum(item["seconds"] for item in items)
    print(f"{report['counts']}, exit code {code}, {os.cpu_count()} processors")
    print(f"{wall:.1f} s by the clock; its processes {alone:.1f} s by the clock one after the other, {processors:.1f} s on processors; the largest {max(item['mebibytes'] for item in items):.0f} MiB")
    print(f"{sum(item['triangles'] or 0 for item in items if item['made']):,} triangles, {sum(item['tetrahedra'] or 0 for item in items if item['made']):,} tetrahedra")
    code, again, _ = batch(folder)
    print(f"again: {again:.1f} s, {json.loads((folder / 'models/batch.json').read_text())['counts']}")
