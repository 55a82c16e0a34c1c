"""What a call from Python costs beyond the C++ call: python_overhead.py [KIND] (molar), with PYTHONPATH=build/release/python.

The report's stages are timed within the C++ call and leave out what lies between them, so their sum is less than that call takes: what is
told is an upper bound. The arrays of all solids are taken, too.
"""
import sys
import time

import odontoscope


def run(stack):
    start = time.perf_counter()
    model = odontoscope.reconstruct(stack)
    for solid in model.solids:
        solid.points, solid.triangles, solid.tetrahedron_points, solid.tetrahedra, solid.labels
    wall = time.perf_counter() - start
    return wall, sum(model.report["seconds"].values())


stack = odontoscope.sample(sys.argv[1] if len(sys.argv) > 1 else "molar")
pairs = sorted((run(stack) for _ in range(9)), key=lambda pair: pair[0] / pair[1])
wall, stages = pairs[len(pairs) // 2]
print(f"call {wall:.3f} s, stages within {stages:.3f} s: at most {100 * (wall / stages - 1):.2f} % beyond (median of {len(pairs)})")
