#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The nine plots of the window, drawn by matplotlib: prints the median time of a redraw after b has changed, in ms.

nine_plots_matplotlib.py SAMPLES WIDTH HEIGHT REDRAWS

The curves are computed beforehand, so that drawing alone is timed. Started by bench_window.
"""

import statistics
import sys
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import numpy

A, C, OMEGA2 = 20.0, 25.0, 2.0 * numpy.pi
REFERENCE_ROWS = 201
TITLES = ["θ³ [°]", "R_x⁴ [mm]", "error [%]"]


def motion(b, samples):
    """θ³ and R_x⁴ with two derivatives each: (position, velocity, acceleration) rows of two."""
    t = numpy.linspace(0.0, 1.0, samples)
    theta2 = OMEGA2 * t
    theta3 = numpy.arcsin((C - A * numpy.sin(theta2)) / b)
    omega3 = -A * OMEGA2 * numpy.cos(theta2) / (b * numpy.cos(theta3))
    alpha3 = (A * OMEGA2**2 * numpy.sin(theta2) + b * omega3**2 * numpy.sin(theta3)) / (b * numpy.cos(theta3))
    x = A * numpy.cos(theta2) + b * numpy.cos(theta3)
    v = -A * OMEGA2 * numpy.sin(theta2) - b * omega3 * numpy.sin(theta3)
    a = -A * OMEGA2**2 * numpy.cos(theta2) - b * alpha3 * numpy.sin(theta3) - b * omega3**2 * numpy.cos(theta3)
    return t, [numpy.degrees(theta3), x, numpy.degrees(omega3), v, numpy.degrees(alpha3), a]


def main():
    samples, width, height, redraws = map(int, sys.argv[1:])
    lengths = [60.0 + 0.5 * (i % 10) for i in range(redraws + 1)]
    motions = {b: motion(b, samples) for b in set(lengths)}
    rows, reference = motion(60.0, REFERENCE_ROWS)

    def errors(b):
        model = motion(b, REFERENCE_ROWS)[1]
        return [100.0 * (m - r) / numpy.max(numpy.abs(r)) for m, r in zip(model, reference)]

    errors_of = {b: errors(b) for b in set(lengths)}
    figure, axes = pyplot.subplots(3, 3, sharex=True, figsize=(width / 100.0, height / 100.0), dpi=100)
    models, differences = [], []
    t, curves = motions[lengths[0]]
    for row in range(3):
        for column in range(2):
            models.append(axes[row, column].plot(t, curves[2 * row + column])[0])
            axes[row, column].plot(rows, reference[2 * row + column], "--")
        for column in range(2):
            differences.append(axes[row, 2].plot(rows, errors_of[lengths[0]][2 * row + column])[0])
    for column, title in enumerate(TITLES):
        axes[0, column].set_title(title)
        axes[2, column].set_xlabel("t [s]")
    figure.canvas.draw()

    times = []
    for b in lengths[1:]:
        curves = motions[b][1]
        start = time.perf_counter()
        for line, values in zip(models, curves):
            line.set_ydata(values)
        for line, values in zip(differences, errors_of[b]):
            line.set_ydata(values)
        figure.canvas.draw()
        times.append(time.perf_counter() - start)
    print(1e3 * statistics.median(times))


if __name__ == "__main__":
    main()
