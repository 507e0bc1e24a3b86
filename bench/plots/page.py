"""What all pictures share: the page with its header, numbers as text, axes, labels, files."""

import math
import os
from collections.abc import Callable
from pathlib import PurePath, Path

from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator, NullLocator

from plots.theme import SMALL, TITLE, Theme

DPI = 150
MARGIN = 0.25
LINE = 0.2
LONGEST_NAME = 48
LOGARITHMIC_FROM = 8  # times the least
BACKENDS = {"tbb": "TBB", "openmp": "OpenMP"}


def number(value: float) -> str:
    """A number as people write it, three digits or more."""
    if value and not 1e-3 <= abs(value) < 1e9:
        mantissa, exponent = f"{value:.2e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    if abs(value) >= 100 or value == int(value):
        return f"{value:,.0f}"
    return f"{value:.3g}"


def tick_text(value: float) -> str:
    """A round number, with all its digits."""
    return f"{value:,.10g}" if not value or 1e-3 <= abs(value) < 1e9 else number(value)


def duration(seconds: float) -> str:
    """A time with its unit."""
    return f"{number(seconds)} s" if seconds >= 0.01 or seconds == 0 else f"{number(1000 * seconds)} ms"


def count(quantity: int, noun: str) -> str:
    """A quantity with its noun, which takes an s."""
    return f"{quantity:,} {noun}" + ("" if quantity == 1 else "s")


def shortened(text: str, longest: int = LONGEST_NAME) -> str:
    """A text in printable characters, without its middle if it is long."""
    text = "".join(letter if letter.isprintable() else "?" for letter in text)
    half = (longest - 1) // 2
    return text if len(text) <= longest else f"{text[:half]}…{text[-half:]}"


def configuration(run: dict) -> str:
    """The name of an engine with its frontier and backend."""
    if run["engine"] == "reference":
        return "reference"
    parts = [run["frontier"], BACKENDS.get(run["backend"], run["backend"])]
    return ", ".join(part for part in parts if part) or "parallel"


def facts(result: dict, own: list[str]) -> list[str]:
    """What the subtitle tells: mesh, machine, the picture's own facts, program."""
    mesh, machine = result["mesh"], result["machine"]
    return [
        f"{shortened(PurePath(mesh['file']).name)}, {count(mesh['triangles'], 'triangle')}",
        *own,
        f"{shortened(machine['processor'])}, {count(machine['threads'], 'thread')}",
        shortened(result["program"]),
    ]


def single_facts(result: dict) -> list[str]:
    """Mesh, machine, graph, seeds and program of a result with one graph and one number of seeds."""
    options = result["options"]
    given = f" from {shortened(PurePath(options['seeds_file']).name)}" if options["seeds_file"] else ""
    return facts(result, [f"{options['graph']} graph", count(options["seeds"], "seed") + given])


def lines_of(parts: list[str], fits: Callable[[str], bool]) -> list[str]:
    """Parts joined to lines that fit."""
    lines = [parts[0]]
    for part in parts[1:]:
        longer = f"{lines[-1]}  ·  {part}"
        lines[-1:] = [longer] if fits(longer) else [lines[-1], part]
    return lines


def page(theme: Theme, size: tuple[float, float], title: str, parts: list[str], warnings: list[str]) -> Figure:
    """A page with title, subtitle and warnings above a space of a size in inches that lays itself out."""
    figure = Figure(dpi=DPI, layout="constrained")
    renderer = FigureCanvasAgg(figure).get_renderer()
    font = FontProperties(family="DejaVu Sans", size=SMALL)

    def fits(text: str) -> bool:
        return renderer.get_text_width_height_descent(text, font, False)[0] < (size[0] - 2 * MARGIN) * DPI

    header = [(line, theme.muted) for line in lines_of(parts, fits)] + [(line, theme.alarm) for line in warnings]
    header_height = MARGIN + 0.32 + LINE * len(header) + 0.1
    height = size[1] + header_height
    figure.set_size_inches(size[0], height)
    figure.text(MARGIN / size[0], 1 - MARGIN / height, title, fontsize=TITLE, weight="bold", va="top")
    for index, (line, colour) in enumerate(header):
        y = 1 - (MARGIN + 0.32 + LINE * index) / height
        figure.text(MARGIN / size[0], y, line, fontsize=SMALL, color=colour, va="top")
    rect = (0.5 * MARGIN / size[0], 0.01, 1 - MARGIN / size[0], size[1] / height - 0.01)
    figure.get_layout_engine().set(rect=rect, h_pad=0.06, w_pad=0.06, wspace=0.03)
    return figure


def interruption(result: dict) -> list[str]:
    """The warning of a result that is not complete."""
    return ["interrupted: only a part of the runs is here"] if result["interrupted"] else []


def log_ticks(low: float, high: float) -> list[float]:
    """Round numbers from low to high for a logarithmic axis, three to eight where they can be had."""
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    for digits in ((1,), (1, 3), (1, 2, 5), (1, 1.5, 2, 3, 5, 7)):
        ticks = [digit * 10.0**decade for decade in decades for digit in digits if low <= digit * 10.0**decade <= high]
        if len(ticks) >= 3:
            return ticks[::math.ceil(len(ticks) / 8)]
    return [tick for tick in MaxNLocator(4).tick_values(low, high) if low <= tick <= high]


def scale_axis(axis: Axis, values: list[float], room: float = 0.06) -> None:
    """From zero, or logarithmic where values span much, with a share of room at the end; thousands separators."""
    values = [value for value in values if value > 0]
    axes, name = axis.axes, axis.axis_name
    set_limits = axes.set_xlim if name == "x" else axes.set_ylim
    if values and max(values) > LOGARITHMIC_FROM * min(values):
        low, high = min(values), max(values)
        low, high = low / (high / low) ** 0.06, high * (high / low) ** room
        (axes.set_xscale if name == "x" else axes.set_yscale)("log")
        set_limits(low, high)
        axis.set_major_locator(FixedLocator(log_ticks(low, high)))
        axis.set_minor_locator(NullLocator())
    else:
        set_limits(0, (1 + room) * max(values, default=1))
        axis.set_major_locator(MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]))
    axis.set_major_formatter(FuncFormatter(lambda value, _: tick_text(value)))


def powers_axis(axes: Axes, values: list[int], most: int = 6) -> None:
    """A base-2 logarithmic x axis with ticks at given values, not too near to each other."""
    values = sorted(set(values))
    low, high = math.log2(values[0]), math.log2(values[-1])
    kept = [values[0]]
    for value in values[1:]:
        if math.log2(value) - math.log2(kept[-1]) >= (high - low) / most:
            kept.append(value)
    room = max(0.06 * (high - low), 0.1)
    axes.set_xscale("log", base=2)
    axes.set_xlim(2 ** (low - room), 2 ** (high + room))
    axes.xaxis.set_major_locator(FixedLocator(kept))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: tick_text(value)))


def spread(positions: list[float], gap: float) -> list[float]:
    """Positions moved apart until each is a gap from the next, in the order given."""
    order = sorted(range(len(positions)), key=positions.__getitem__)
    placed = list(positions)
    for _ in range(200):
        for lower, upper in zip(order, order[1:]):
            missing = gap - (placed[upper] - placed[lower])
            if missing > 1e-6:
                placed[lower] -= missing / 2
                placed[upper] += missing / 2
    return placed


def end_labels(axes: Axes, ends: list[tuple[float, float, str, str]], height: float) -> None:
    """Names lines right of the axes, where they end: x, y, text and colour of each; height of the axes in inches."""
    to_fraction = axes.transData + axes.transAxes.inverted()
    fractions = [to_fraction.transform((x, y)) for x, y, _, _ in ends]
    placed = spread([y for _, y in fractions], 1.35 * SMALL / 72 / height)
    for (x, y), label_y, (_, _, text, colour) in zip(fractions, placed, ends):
        axes.annotate(text, xy=(x, y), xytext=(1.05, label_y), xycoords="axes fraction", textcoords="axes fraction",
                      color=colour, fontsize=SMALL, va="center",
                      arrowprops={"arrowstyle": "-", "color": colour, "lw": 0.6, "shrinkA": 1, "shrinkB": 4})


def save(figure: Figure, path: Path) -> None:
    """Writes a picture under a temporary name, then renames it."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        figure.savefig(temporary, format="png", dpi=DPI)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)
