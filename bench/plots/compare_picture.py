"""The picture of geolloyd compare: speed-up over the reference, and time."""

from collections.abc import Callable, Iterator, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plots.page import (configuration, count, duration, end_labels, interruption, number, page, powers_axis,
                        scale_axis, single_facts)
from plots.theme import SMALL, Theme

WIDTH = 11.5
LINES_HEIGHT = 5.2
ROW_HEIGHT = 0.34
FEWEST_FOR_LINES = 3  # thread counts
MOST_NAMED = 3
SPEEDUP_ROOM, TIME_ROOM = 0.2, 0.5  # for words right of the dots, shares of the axes

Value = Callable[[dict], tuple[float, float, float]]  # the middle, the least and the greatest


def time_of(run: dict) -> tuple[float, float, float]:
    """Median, least and greatest time."""
    return run["seconds"]["median"], run["seconds"]["min"], run["seconds"]["max"]


def speedup_of(run: dict) -> tuple[float, float, float]:
    """The speed-up of the median, and those of the slowest and the fastest turn."""
    speedup, times = run["speedup"], run["seconds"]
    reference = speedup * times["median"]
    slowest, fastest = (reference / time if time > 0 else speedup for time in (times["max"], times["min"]))
    return speedup, slowest, fastest


def row_name(run: dict) -> str:
    """A configuration with its threads."""
    name = configuration(run)
    return name if run["engine"] == "reference" else f"{name}, {count(run['threads'], 'thread')}"


def warnings_of(result: dict) -> list[str]:
    """What is wrong with the runs: interruption, results that differ."""
    different = [row_name(run) for run in result["runs"] if not run["equal"]]
    if not different:
        return interruption(result)
    more = f" and {len(different) - MOST_NAMED} more" if len(different) > MOST_NAMED else ""
    named = "; ".join(different[:MOST_NAMED]) + more
    return [f"× the result differs from the reference: {named}", *interruption(result)]


def style_of(run: dict, theme: Theme) -> dict:
    """Colour by frontier, filled dots and full lines or hollow dots and dashes by backend."""
    colours = {"regions": theme.blue, "delta": theme.orange, "heap": theme.green, "auto": theme.purple}
    colour = theme.muted if run["engine"] == "reference" else colours.get(run["frontier"], theme.sky)
    hollow = run["backend"] == "openmp"
    return {"color": colour, "markerfacecolor": theme.background if hollow else colour,
            "linestyle": (0, (5, 2)) if hollow else "-"}


def mark_different(axes: Axes, x: float, y: float, theme: Theme) -> None:
    """A red cross on a run whose result differs."""
    axes.plot([x], [y], marker="x", markersize=11, markeredgewidth=2.4, color=theme.alarm, zorder=5)


def whiskers(middles: Sequence[float], lows: Sequence[float], highs: Sequence[float]) -> list[list[float]]:
    """Lengths of whiskers to both sides, none where rounding has moved an end past the middle."""
    return [[max(middle - low, 0) for middle, low in zip(middles, lows)],
            [max(high - middle, 0) for middle, high in zip(middles, highs)]]


def draw_line(axes: Axes, runs: list[dict], value: Value, theme: Theme) -> None:
    """A line over threads with whiskers."""
    threads = [run["threads"] for run in runs]
    middles, lows, highs = zip(*map(value, runs))
    axes.errorbar(threads, middles, yerr=whiskers(middles, lows, highs), marker="o", markersize=5.5, linewidth=1.6,
                  elinewidth=1.1, capsize=3, **style_of(runs[0], theme))
    for run, x, y in zip(runs, threads, middles):
        if not run["equal"]:
            mark_different(axes, x, y, theme)


def draw_lines(axes: Axes, series: list[list[dict]], value: Value, reference: tuple | None, rises: bool,
               theme: Theme) -> None:
    """All configurations over threads, the reference as a level, and ideal scaling of the fastest one."""
    threads = sorted({run["threads"] for runs in series for run in runs})
    values = [bound for runs in series for run in runs for bound in value(run)]
    power = 1 if rises else -1
    single = [value(runs[0])[0] / runs[0]["threads"] ** power for runs in series]
    ideal = [(max if rises else min)(single) * t**power for t in threads]
    scale_axis(axes.yaxis, [*values, *ideal, *(reference or ())])
    powers_axis(axes, threads, most=12)
    axes.plot(threads, ideal, color=theme.muted, linewidth=0.9, linestyle=":")
    ends = [(threads[-1], ideal[-1], "ideal", theme.muted)]
    if reference:
        axes.axhspan(reference[1], reference[2], color=theme.faint(theme.muted), linewidth=0)
        axes.axhline(reference[0], color=theme.muted, linewidth=1.4)
        ends.append((axes.get_xlim()[1], reference[0], "reference", theme.muted))
    for runs in series:
        draw_line(axes, runs, value, theme)
        style = style_of(runs[0], theme)
        ends.append((runs[-1]["threads"], value(runs[-1])[0], configuration(runs[0]), theme.ink(style["color"])))
    axes.set_xlabel("threads")
    axes.grid(True)
    end_labels(axes, ends, 0.85 * LINES_HEIGHT)


def draw_rows(axes: Axes, runs: list[dict], value: Value, text: Callable[[dict], str], room: float,
              theme: Theme) -> None:
    """A row per run: a dot with whiskers, its value beside it."""
    axes.set_ylim(len(runs) - 0.5, -0.5)
    axes.set_yticks(range(len(runs)), [row_name(run) for run in runs])
    shown = [(row, run, *value(run)) for row, run in enumerate(runs) if value is time_of or run["speedup"] is not None]
    scale_axis(axes.xaxis, [bound for _, _, *bounds in shown for bound in bounds], room)
    for row, run, middle, low, high in shown:
        axes.errorbar([middle], [row], xerr=whiskers([middle], [low], [high]), marker="o", markersize=7, capsize=3,
                      elinewidth=1.2, **style_of(run, theme))
        axes.annotate(text(run), xy=(high, row), xytext=(9, 0), textcoords="offset points", va="center", fontsize=SMALL)
        if not run["equal"]:
            mark_different(axes, middle, row, theme)
    axes.grid(True, axis="x")
    axes.grid(True, axis="y", linestyle=":")
    axes.tick_params(axis="y", length=0)


def time_text(run: dict) -> str:
    """Time and throughput of a run."""
    return f"{duration(run['seconds']['median'])}, {number(run['node_visits_per_second'] / 1e6)} M visits/s"


def draw_row_picture(figure: Figure, runs: list[dict], relative: bool, theme: Theme) -> list[Axes]:
    """Panels with a row per run; the panel of speed-ups is there if they are known."""
    panels = list(figure.subplots(1, 1 + relative, squeeze=False, sharey=True)[0])
    if relative:
        draw_rows(panels[0], runs, speedup_of, lambda run: f"{number(run['speedup'])}×", SPEEDUP_ROOM, theme)
    draw_rows(panels[-1], runs, time_of, time_text, TIME_ROOM, theme)
    for label, run in zip(panels[0].get_yticklabels(), runs):
        label.set_color(theme.text if run["equal"] else theme.alarm)
    return panels


def draw_line_picture(figure: Figure, runs: list[dict], relative: bool, theme: Theme) -> list[Axes]:
    """Panels with a line per configuration; the panel of speed-ups is there if they are known."""
    parallel = sorted((run for run in runs if run["engine"] == "parallel"), key=lambda run: run["threads"])
    names = dict.fromkeys(configuration(run) for run in runs if run["engine"] == "parallel")
    series = [[run for run in parallel if configuration(run) == name] for name in names]
    reference = next((time_of(run) for run in runs if run["engine"] == "reference"), None)
    panels = list(figure.subplots(1, 1 + relative, squeeze=False)[0])
    if relative:
        known = [kept for kept in ([run for run in line if run["speedup"] is not None] for line in series) if kept]
        draw_lines(panels[0], known, speedup_of, (1, 1, 1), True, theme)
    draw_lines(panels[-1], series, time_of, reference, False, theme)
    return panels


def draw(result: dict, theme: Theme) -> Figure:
    """The whole picture: lines over threads, or rows where there are few thread counts."""
    runs = result["runs"]
    parallel = [run for run in runs if run["engine"] == "parallel"]
    relative = any(run["speedup"] is not None for run in parallel)
    as_lines = len({run["threads"] for run in parallel}) >= FEWEST_FOR_LINES
    title = "Speed-up of the parallel engine over the reference" if relative else "Time of the relaxation"
    turns = max(run["turns"] for run in runs)
    turns_text = f"medians of {turns:,} turns, whiskers: least to most" if turns > 1 else "one turn each"
    parts = [*single_facts(result), turns_text]
    height = LINES_HEIGHT if as_lines else 0.9 + ROW_HEIGHT * max(len(runs), 3)
    figure = page(theme, (WIDTH, height), title, parts, warnings_of(result))
    panels = (draw_line_picture if as_lines else draw_row_picture)(figure, runs, relative, theme)
    if relative:
        panels[0].set_title("speed-up (reference = 1)")
    panels[-1].set_title("time of the relaxation (s)")
    return figure


def pictures(result: dict) -> Iterator[tuple[str, Callable]]:
    """What the file's name has after its stem, and who draws it."""
    yield "", draw
