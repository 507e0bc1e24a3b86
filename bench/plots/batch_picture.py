"""The pictures of geolloyd batch: parallel coordinates, and cost by number of seeds."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from plots.page import LOGARITHMIC_FROM, count, facts, interruption, number, page, powers_axis, scale_axis
from plots.result import GRAPHS, GREEDY_MODES
from plots.theme import SMALL, Theme

WIDTH = 11.5
PANEL_HEIGHT = 3.0
LADDER_PANEL_HEIGHT = 2.75
JITTER = 0.07  # to each side, of the height of a coordinate
MOST_BANDS = 6  # of a panel; more would hide each other


@dataclass
class Coordinate:
    """A vertical axis of parallel coordinates: where each row is on it, from 0 to 1, and the words at its ends."""

    name: str
    places: list[float]
    low: str = ""
    high: str = ""


def graphs_of(rows: list[dict]) -> list[str]:
    """The graph kinds of some rows, in the usual order."""
    return [graph for graph in GRAPHS if any(row["graph"] == graph for row in rows)]


def modes_of(rows: list[dict]) -> list[str]:
    """The greedy modes of some rows, in the usual order."""
    return [mode for mode in GREEDY_MODES if any(row["greedy"] == mode for row in rows)]


def mode_colour(mode: str, theme: Theme) -> str:
    """The colour of a greedy mode."""
    return {"off": theme.orange, "standard": theme.blue, "extended": theme.green}[mode]


def jittered(places: list[float], room: float) -> list[float]:
    """Places moved a little, those that are the same side by side in the order given, so that lines do not coincide."""
    moved = list(places)
    for place in set(places):
        same = [index for index, other in enumerate(places) if other == place]
        middle = (len(same) - 1) / 2
        for rank, index in enumerate(same):
            moved[index] += room * (rank - middle) / max(middle, 1)
    return moved


def switch(name: str, states: list[bool]) -> Coordinate:
    """A coordinate that is on or off."""
    return Coordinate(name, jittered([float(state) for state in states], JITTER), "off", "on")


def noted(name: str, *remarks: str) -> str:
    """A name with remarks below, those that are not empty."""
    said = ", ".join(remark for remark in remarks if remark)
    return f"{name}\n({said})" if said else name


def numeric(name: str, values: list[float], unit: str = "", remark: str = "") -> Coordinate:
    """A coordinate of numbers, from the least to the greatest; logarithmic where they span much."""
    low, high = min(values), max(values)
    if low == high:
        text = number(low) + unit
        return Coordinate(noted(name, remark), [0.5] * len(values), "", text if len(values) == 1 else f"all {text}")
    logarithmic = low > 0 and high > LOGARITHMIC_FROM * low
    scale = math.log if logarithmic else float
    places = [(scale(value) - scale(low)) / (scale(high) - scale(low)) for value in values]
    full_name = noted(name, remark, "log" if logarithmic else "")
    return Coordinate(full_name, places, number(low) + unit, number(high) + unit)


def coordinates_of(rows: list[dict], several_seeds: bool) -> list[Coordinate]:
    """The axes of a panel, from what was chosen to what came of it."""
    modes = [GREEDY_MODES.index(row["greedy"]) / (len(GREEDY_MODES) - 1) for row in rows]
    seeds = numeric("seeds", [row["seeds"] for row in rows])
    seeds.places = jittered(seeds.places, JITTER / 2)

    def average(name: str, key: str, unit: str = "", remark: str = "") -> Coordinate:
        return numeric(name, [row[key]["avg"] for row in rows], unit, remark)

    return [
        Coordinate("greedy mode", jittered(modes, JITTER)),
        switch("macrostep\noptimisation", [row["macrostep_skip"] for row in rows]),
        switch("microstep\noptimisation", [row["microstep_skip"] for row in rows]),
        *([seeds] if several_seeds else []),
        average("greedy steps", "greedy_steps"),
        average("macrosteps", "macrosteps"),
        average("microsteps", "microsteps"),
        average("time", "seconds", " s"),
        average("energy", "energy", remark="mesh units"),
    ]


def draw_panel(axes: Axes, rows: list[dict], several_seeds: bool, theme: Theme) -> None:
    """Parallel coordinates of the rows of a graph kind."""
    rows = sorted(rows, key=lambda row: (GREEDY_MODES.index(row["greedy"]), row["seeds"]))
    coordinates = coordinates_of(rows, several_seeds)
    places = range(len(coordinates))
    for index, row in enumerate(rows):
        axes.plot(places, [coordinate.places[index] for coordinate in coordinates], linewidth=1.3,
                  color=mode_colour(row["greedy"], theme), alpha=0.85 if len(rows) <= 24 else 0.55)
    for x, coordinate in enumerate(coordinates):
        axes.axvline(x, color=theme.muted, linewidth=1, zorder=1)
        axes.annotate(coordinate.high, xy=(x, 1.1), ha="center", va="bottom", fontsize=SMALL, annotation_clip=False)
        axes.annotate(coordinate.low, xy=(x, -0.1), ha="center", va="top", fontsize=SMALL, annotation_clip=False)
    for index, mode in enumerate(GREEDY_MODES):
        axes.annotate(mode, xy=(-0.1, index / (len(GREEDY_MODES) - 1)), ha="right", va="center", fontsize=SMALL,
                      color=theme.ink(mode_colour(mode, theme)), weight="bold")
    axes.set(xlim=(-0.1, len(coordinates) - 0.7), ylim=(-0.09, 1.09), yticks=[])
    axes.set_xticks(places, [coordinate.name for coordinate in coordinates])
    axes.tick_params(axis="x", length=0, pad=18)
    axes.spines[:].set_visible(False)
    axes.set_title(f"{rows[0]['graph']} graph, {count(len(rows), 'setting')}", weight="bold", pad=20)


def facts_of(result: dict) -> list[str]:
    """What the subtitle tells: mesh, engine, seeds, runs, machine, program."""
    rows, options = result["rows"], result["options"]
    seeds = sorted({row["seeds"] for row in rows})
    seeds_text = count(seeds[0], "seed") if len(seeds) == 1 else f"{seeds[0]:,} to {seeds[-1]:,} seeds"
    runs, converged = sum(row["batches"] for row in rows), sum(row["converged"] for row in rows)
    graphs = graphs_of(rows)
    graphs_text = f"{graphs[0]} graph" if len(graphs) == 1 else f"{len(graphs)} kinds of graph"
    engine = f"{options['engine']} engine on {count(options['threads'], 'thread')}"
    runs_text = f"{count(runs, 'run')}, {'all' if converged == runs else f'{converged:,}'} converged"
    return facts(result, [graphs_text, seeds_text, engine, runs_text])


def draw_coordinates(result: dict, theme: Theme) -> Figure:
    """Parallel coordinates, a panel for each graph kind."""
    rows = result["rows"]
    graphs = graphs_of(rows)
    several_seeds = len({row["seeds"] for row in rows}) > 1
    parts = [*facts_of(result), "each line: averages of a setting"]
    size = WIDTH, PANEL_HEIGHT * len(graphs)
    figure = page(theme, size, "What greedy modes and optimisations cost and bring", parts, interruption(result))
    for axes, graph in zip(figure.subplots(len(graphs), 1, squeeze=False)[:, 0], graphs):
        draw_panel(axes, [row for row in rows if row["graph"] == graph], several_seeds, theme)
    return figure


def graph_colours(theme: Theme) -> dict[str, str]:
    """A colour for each graph kind."""
    return dict(zip(GRAPHS, (theme.blue, theme.sky, theme.orange, theme.vermillion, theme.purple, theme.green)))


BOUNDS = ("min", "avg", "max")
MODE_LINES = {"off": ":", "standard": (0, (5, 2)), "extended": "-"}
LADDERS = {"seconds": "time (s)", "greedy_steps": "greedy steps", "macrosteps": "macrosteps",
           "microsteps": "microsteps", "scaled_energy": "energy × seeds (mesh units)"}


def ladder_rows(rows: list[dict]) -> list[dict]:
    """The rows with the optimisations that are on most, so that one setting is followed from seeds to seeds.

    Energy falls as one over seeds; times seeds it shows what differs.
    """
    macro, micro = max((row["macrostep_skip"], row["microstep_skip"]) for row in rows)
    return [{**row, "scaled_energy": {bound: row["energy"][bound] * row["seeds"] for bound in BOUNDS}}
            for row in rows if (row["macrostep_skip"], row["microstep_skip"]) == (macro, micro)]


def ladders_of(rows: list[dict], key: str) -> list[list[dict]]:
    """For each graph kind and greedy mode the rows by seeds, if the quantity is ever more than zero in them."""
    rows = sorted(rows, key=lambda row: row["seeds"])
    lines = [[row for row in rows if (row["graph"], row["greedy"]) == (graph, mode)]
             for graph in graphs_of(rows) for mode in modes_of(rows)]
    return [line for line in lines if any(row[key]["max"] > 0 for row in line)]


def draw_ladder_panel(axes: Axes, rows: list[dict], key: str, theme: Theme) -> None:
    """A quantity over seeds: lines of averages, and bands from least to most where there are few."""
    lines = ladders_of(rows, key)
    scale_axis(axes.yaxis, [row[key][bound] for line in lines for row in line for bound in BOUNDS])
    for line in lines:
        colour = graph_colours(theme)[line[0]["graph"]]
        seeds = [row["seeds"] for row in line]
        if len(lines) <= MOST_BANDS:
            axes.fill_between(seeds, [row[key]["min"] for row in line], [row[key]["max"] for row in line],
                              color=colour, alpha=0.15, linewidth=0)
        axes.plot(seeds, [row[key]["avg"] for row in line], color=colour, linestyle=MODE_LINES[line[0]["greedy"]],
                  linewidth=1.5, marker="o", markersize=3)
    powers_axis(axes, [row["seeds"] for row in rows])
    axes.set_title(LADDERS[key])
    axes.set_xlabel("seeds")
    axes.grid(True)


def draw_keys(axes: Axes, rows: list[dict], theme: Theme) -> None:
    """Says which line is which."""
    colours = graph_colours(theme)
    handles = [Line2D([], [], color=colours[graph], linewidth=3, label=f"{graph} graph") for graph in graphs_of(rows)]
    handles += [Line2D([], [], color=theme.text, linewidth=1.5, linestyle=MODE_LINES[mode], label=f"greedy mode {mode}")
                for mode in modes_of(rows)]
    axes.set_axis_off()
    axes.legend(handles=handles, loc="center left", handlelength=3, fontsize=SMALL + 1, labelspacing=0.7)


def draw_ladder(result: dict, theme: Theme) -> Figure:
    """What more seeds cost and bring."""
    rows = ladder_rows(result["rows"])
    keys = [key for key in LADDERS if any(row[key]["avg"] > 0 for row in rows)]
    on = [name for name, key in (("macrostep", "macrostep_skip"), ("microstep", "microstep_skip")) if rows[0][key]]
    optimised = f"{' and '.join(on)} optimisation on" if on else "without optimisations"
    banded = len(ladders_of(rows, "seconds")) <= MOST_BANDS
    parts = [*facts_of({**result, "rows": rows}), optimised,
             "averages, in bands from least to most" if banded else "averages"]
    size = WIDTH, 2 * LADDER_PANEL_HEIGHT
    figure = page(theme, size, "What more seeds cost and bring", parts, interruption(result))
    panels = list(figure.subplots(2, 3).flat)
    for axes, key in zip(panels, keys):
        draw_ladder_panel(axes, rows, key, theme)
    draw_keys(panels[len(keys)], rows, theme)
    for axes in panels[len(keys) + 1:]:
        axes.set_axis_off()
    return figure


def pictures(result: dict) -> Iterator[tuple[str, Callable]]:
    """What the file's name has after its stem, and who draws it."""
    yield "", draw_coordinates
    if len({row["seeds"] for row in ladder_rows(result["rows"])}) > 1:
        yield "-ladder", draw_ladder
