"""What the module costs beside the same loops in C++: python3 loops.py PROGRAM, the built python_loops.

CPU seconds for a million values, the least of three runs each.
"""

import subprocess
import sys
import time

import numpy as np

import ricochet

COUNT = 1_000_000


def least_seconds(function):
    seconds = []
    for _ in range(3):
        start = time.process_time()
        function()
        seconds.append(time.process_time() - start)
    return min(seconds)


x, en = np.linspace(-16, 2, COUNT), np.linspace(0.05, 0.99, COUNT)
python = [
    least_seconds(lambda: ricochet.mittag_leffler(1.5, 2.0, x)),
    least_seconds(lambda: ricochet.calibrate("fractional", 1e-4, en)),
]
cpp = map(float, subprocess.run([sys.argv[1]], check=True, capture_output=True, text=True).stdout.split())
print(f"{'a million of':28s}{'Python [s]':>12s}{'C++ [s]':>10s}{'ratio':>8s}")
for name, ours, theirs in zip(("mittag_leffler(1.5, 2, x)", "calibrate, fractional"), python, cpp):
    print(f"{name:28s}{ours:12.3f}{theirs:10.3f}{ours / theirs:8.2f}")
