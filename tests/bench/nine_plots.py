#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The nine plots of the window, drawn by another library: prints the median time of a redraw after b has changed, in ms.

nine_plots.py matplotlib|pyqtgraph SAMPLES WIDTH HEIGHT REDRAWS

The curves are computed beforehand, so that drawing alone is timed. Started by bench_window.
"""

import statistics
import sys
import time

import numpy

A, C, OMEGA2 = 20.0, 25.0, 2.0 * numpy.pi
REFERENCE_ROWS = 201
TITLES = ["θ³ [°]", "R_x⁴ [mm]", "error [%]"]


def motion(b, samples):
    """Returns the times (s) and six curves: θ³ (°) and R_x⁴ (mm), their velocities, and their accelerations."""
    t = numpy.linspace(0.0, 1.0, samples)
    theta2 = OMEGA2 * t
    theta3 = numpy.arcsin((C - A * numpy.sin(theta2)) / b)
    omega3 = -A * OMEGA2 * numpy.cos(theta2) / (b * numpy.cos(theta3))
    alpha3 = (A * OMEGA2**2 * numpy.sin(theta2) + b * omega3**2 * numpy.sin(theta3)) / (b * numpy.cos(theta3))
    x = A * numpy.cos(theta2) + b * numpy.cos(theta3)
    v = -A * OMEGA2 * numpy.sin(theta2) - b * omega3 * numpy.sin(theta3)
    a = -A * OMEGA2**2 * numpy.cos(theta2) - b * alpha3 * numpy.sin(theta3) - b * omega3**2 * numpy.cos(theta3)
    return t, [numpy.degrees(theta3), x, numpy.degrees(omega3), v, numpy.degrees(alpha3), a]


class Matplotlib:
    """Draws with Matplotlib into a picture in memory."""

    def __init__(self, width, height):
        import matplotlib

        matplotlib.use("Agg")
        import matplotlib.pyplot as pyplot

        self.figure, self.axes = pyplot.subplots(
            3, 3, sharex=True, figsize=(width / 100.0, height / 100.0), dpi=100
        )
        for column, title in enumerate(TITLES):
            self.axes[0, column].set_title(title)
            self.axes[2, column].set_xlabel("t [s]")

    def plot(self, row, column, t, values, dashed):
        return self.axes[row, column].plot(t, values, "--" if dashed else "-")[0]

    def set_values(self, line, t, values):
        line.set_ydata(values)

    def draw(self):
        self.figure.canvas.draw()


class PyQtGraph:
    """Draws with PyQtGraph into a picture of the same size: with smooth edges, as the window, and with its own downsampling."""

    def __init__(self, width, height):
        import pyqtgraph

        pyqtgraph.setConfigOptions(antialias=True)
        self.application = pyqtgraph.mkQApp()
        self.pens = [pyqtgraph.mkPen(width=1.5), pyqtgraph.mkPen(width=1.5, style=pyqtgraph.QtCore.Qt.PenStyle.DashLine)]
        self.view = pyqtgraph.GraphicsLayoutWidget()
        self.view.resize(width, height)
        self.axes = [[self.view.addPlot(row, column) for column in range(3)] for row in range(3)]
        for plots in self.axes:
            for plot in plots:
                plot.setDownsampling(auto=True, mode="peak")
                plot.setClipToView(True)
        for column, title in enumerate(TITLES):
            self.axes[0][column].setTitle(title)
            self.axes[2][column].setLabel("bottom", "t [s]")
        self.view.show()

    def plot(self, row, column, t, values, dashed):
        return self.axes[row][column].plot(t, values, pen=self.pens[dashed])

    def set_values(self, line, t, values):
        line.setData(t, values)

    def draw(self):
        self.application.processEvents()
        self.view.grab()


def main():
    library = {"matplotlib": Matplotlib, "pyqtgraph": PyQtGraph}[sys.argv[1]]
    samples, width, height, redraws = map(int, sys.argv[2:])
    coupler_lengths = [60.0 + 0.5 * (i % 10) for i in range(redraws + 1)]
    motions = {b: motion(b, samples) for b in set(coupler_lengths)}
    reference_times, reference = motion(60.0, REFERENCE_ROWS)

    def errors(b):
        model = motion(b, REFERENCE_ROWS)[1]
        return [100.0 * (m - r) / numpy.max(numpy.abs(r)) for m, r in zip(model, reference)]

    errors_of = {b: errors(b) for b in set(coupler_lengths)}
    figure = library(width, height)
    model_lines, error_lines = [], []
    t, curves = motions[coupler_lengths[0]]
    for row in range(3):
        for column in range(2):
            model_lines.append(figure.plot(row, column, t, curves[2 * row + column], dashed=False))
            figure.plot(row, column, reference_times, reference[2 * row + column], dashed=True)
        for column in range(2):
            error_lines.append(figure.plot(row, 2, reference_times, errors_of[coupler_lengths[0]][2 * row + column], dashed=False))
    figure.draw()

    times = []
    for b in coupler_lengths[1:]:
        curves = motions[b][1]
        start = time.perf_counter()
        for line, values in zip(model_lines, curves):
            figure.set_values(line, t, values)
        for line, values in zip(error_lines, errors_of[b]):
            figure.set_values(line, reference_times, values)
        figure.draw()
        times.append(time.perf_counter() - start)
    print(1e3 * statistics.median(times))


if __name__ == "__main__":
    main()
