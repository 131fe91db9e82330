"""The sweep benchmark by SciPy, and by a Runge-Kutta method of order 8 compiled with numba where numba is installed.

Prints microseconds of one core per speed and period; see ../main.rs for the work. Every `STRIDE`-th of the 200 speeds is taken."""

import sys
import time

import numpy as np
from scipy.integrate import DOP853, solve_ivp

M, BASE, C0, C1, C2, CHI0 = 2.4, 25.0, 1.1e7, 8.7e10, 3.26e5, 6.59
PERIODS = 250
CASES = {"A": (42.0, 1e-3), "B": (420.0, 1e-5)}
STRIDE = int(sys.argv[1]) if len(sys.argv) > 1 else 40


def rhs(t, y, w, damping, e):
    dx, dy = y[0] - y[2], y[1] - y[3]
    fx, fy = dx * (C0 + C1 * dx * dx), dy * (C0 + C1 * dy * dy)
    a = e * w * w
    return np.array(
        [
            y[4],
            y[5],
            y[6],
            y[7],
            a * np.cos(w * t) - (damping * y[4] + fx) / M,
            a * np.sin(w * t) - (damping * y[5] + fy) / M,
            (fx - C2 * y[2] - CHI0 * y[6]) / BASE,
            (fy - C2 * y[3] - CHI0 * y[7]) / BASE,
        ]
    )


def report(name, start, speeds, y):
    cost = (time.process_time() - start) / (len(speeds) * PERIODS) * 1e6
    print(f"    {name:24} {cost:9.2f} us per speed and period, last end state {y[0]:.9e}")


def by_scipy(case):
    damping, e = CASES[case]
    speeds = np.arange(1, 201)[STRIDE - 1 :: STRIDE] * 25.0
    start = time.process_time()
    for w in speeds:
        end = PERIODS * 2 * np.pi / w
        y = solve_ivp(rhs, (0, end), np.zeros(8), "DOP853", args=(w, damping, e), rtol=1e-8, atol=1e-11).y[:, -1]
    report("SciPy, DOP853", start, speeds, y)


def by_numba(case):
    try:
        from numba import njit
    except ImportError:
        print("    numba is not installed")
        return
    # the stages of the method: coefficients from SciPy's own tables
    a, b, c = np.ascontiguousarray(DOP853.A), np.ascontiguousarray(DOP853.B), np.ascontiguousarray(DOP853.C)
    e3, e5 = np.ascontiguousarray(DOP853.E3), np.ascontiguousarray(DOP853.E5)

    @njit(fastmath=False)
    def f(t, y, w, damping, e, out):
        dx, dy = y[0] - y[2], y[1] - y[3]
        fx, fy = dx * (C0 + C1 * dx * dx), dy * (C0 + C1 * dy * dy)
        s = e * w * w
        out[0], out[1], out[2], out[3] = y[4], y[5], y[6], y[7]
        out[4] = s * np.cos(w * t) - (damping * y[4] + fx) / M
        out[5] = s * np.sin(w * t) - (damping * y[5] + fy) / M
        out[6] = (fx - C2 * y[2] - CHI0 * y[6]) / BASE
        out[7] = (fy - C2 * y[3] - CHI0 * y[7]) / BASE

    @njit(fastmath=False)
    def run(w, damping, e, end, rtol, atol):
        n, stages = 8, 12
        y, z = np.zeros(n), np.zeros(n)
        k = np.zeros((stages + 1, n))
        t, h = 0.0, 1e-2 / w
        f(t, y, w, damping, e, k[0])
        while t < end:
            h = min(h, end - t)
            for i in range(1, stages):
                for j in range(n):
                    s = 0.0
                    for m in range(i):
                        s += a[i, m] * k[m, j]
                    z[j] = y[j] + h * s
                f(t + c[i] * h, z, w, damping, e, k[i])
            for j in range(n):
                s = 0.0
                for m in range(stages):
                    s += b[m] * k[m, j]
                z[j] = y[j] + h * s
            f(t + h, z, w, damping, e, k[stages])
            n5, n3 = 0.0, 0.0
            for j in range(n):
                scale = atol + rtol * max(abs(y[j]), abs(z[j]))
                x5, x3 = 0.0, 0.0
                for m in range(stages + 1):
                    x5 += e5[m] * k[m, j]
                    x3 += e3[m] * k[m, j]
                n5 += (x5 / scale) ** 2
                n3 += (x3 / scale) ** 2
            error = h * n5 / np.sqrt((n5 + 0.01 * n3) * n) if n5 > 0 else 0.0
            if error < 1:
                t += h
                y[:] = z
                k[0] = k[stages]
            h *= min(6.0, max(1 / 3, 0.9 * error ** (-1 / 8))) if error > 0 else 6.0
        return y

    damping, e = CASES[case]
    speeds = np.arange(1, 201) * 25.0
    run(100.0, damping, e, 0.1, 1e-8, 1e-11)
    start = time.process_time()
    for w in speeds:
        y = run(w, damping, e, PERIODS * 2 * np.pi / w, 1e-8, 1e-11)
    report("numba, order 8", start, speeds, y)


for case in CASES:
    print(f"case {case}")
    by_scipy(case)
    by_numba(case)
