"""The picture of bench/studies/local_minima: energy against time, of one case step by step, and of all cases."""

from collections.abc import Callable, Iterator

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from plots.page import count, interruption, log_ticks, shortened, tick_text, page
from plots.theme import SMALL, Theme

WIDTH, HEIGHT = 11.5, 5
STYLES = {False: "-", True: (0, (3, 1.5))}


def colour_of(way: str, theme: Theme) -> str:
    """By the first seeds."""
    return {"farthest": theme.grey, "coarse": theme.orange, "surface": theme.blue}[way.split(",")[0]]


def marker_of(way: str) -> str:
    """By what follows."""
    return "^" if "greedy" in way else "o" if "rounds" in way else "s"


def logarithmic_time(axes: Axes, seconds: list[float]) -> None:
    """An x axis for them."""
    low, high = min(seconds) / 1.2, max(seconds) * 1.2
    axes.set_xscale("log")
    axes.set_xlim(low, high)
    axes.xaxis.set_major_locator(FixedLocator(log_ticks(low, high)))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: tick_text(value)))


def draw_course(axes: Axes, row: dict, theme: Theme) -> None:
    """Energy over seconds, of the largest case without a metric of its own."""
    last = row["runs"]["farthest"]["energy"]
    seconds = []
    for way, run in row["runs"].items():
        xs = [step["seconds"] for step in run["course"]]
        ys = [step["energy"] / last for step in run["course"]]
        seconds += xs
        axes.plot(xs, ys, color=colour_of(way, theme), linestyle=STYLES["rounds" in way], linewidth=1.5)
        axes.plot(xs[-1:], ys[-1:], marker_of(way), color=colour_of(way, theme), markersize=6, label=way)
    logarithmic_time(axes, seconds)
    axes.grid(True)
    axes.set_title(f"{row['name']}, {count(row['seeds'], 'seed')}: each step")
    axes.set_xlabel("seconds, first seeds included")
    axes.set_ylabel("energy / that of farthest points, relaxed")


def draw_all(axes: Axes, rows: list[dict], theme: Theme) -> None:
    """The ends of all runs."""
    times = []
    for way in rows[0]["runs"]:
        if way == "farthest":
            continue
        firsts = [row["runs"]["farthest"] for row in rows]
        runs = [row["runs"][way] for row in rows]
        xs = [run["seconds"] / first["seconds"] for run, first in zip(runs, firsts)]
        ys = [run["energy"] / first["energy"] for run, first in zip(runs, firsts)]
        times += xs
        axes.plot(xs, ys, marker_of(way), color=colour_of(way, theme), markersize=5, alpha=0.8)
    axes.plot([1], [1], "s", color=colour_of("farthest", theme), markersize=7)
    logarithmic_time(axes, times)
    axes.grid(True)
    axes.set_title(f"{count(len(rows), 'case')}: the ends")
    axes.set_xlabel("seconds / those of farthest points, relaxed")


def draw(result: dict, theme: Theme) -> Figure:
    """Two panels: one case, and all."""
    rows = result["rows"]
    machine = result["machine"]
    parts = [count(len(rows), "case") + " of mesh, graph and number of seeds", "single runs",
             f"{shortened(machine['processor'])}, {count(machine['threads'], 'thread')}", shortened(result["program"])]
    figure = page(theme, (WIDTH, HEIGHT), "Ways out of local minima: energy and time", parts, interruption(result))
    panels = figure.subplots(1, 2, sharey=True)
    plain = [row for row in rows if " " not in row["name"]] or rows
    shown = max(plain, key=lambda row: (row["seeds"] == 2048, row["runs"]["farthest"]["seconds"]))
    draw_course(panels[0], shown, theme)
    draw_all(panels[1], rows, theme)
    ends = [run["energy"] / row["runs"]["farthest"]["energy"] for row in rows for run in row["runs"].values()]
    panels[0].set_ylim(min(ends) - 0.01, 1.05)
    panels[0].legend(loc="lower left", ncol=2, fontsize=SMALL)
    return figure


def pictures(_: dict) -> Iterator[tuple[str, Callable[[dict, Theme], Figure]]]:
    """The only picture."""
    yield "", draw
