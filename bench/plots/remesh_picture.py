"""The picture of geolloyd remesh's report: energy by iteration and by time, level after level."""

from collections.abc import Callable, Iterator
from pathlib import PurePath

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from plots.page import count, duration, facts, number, page
from plots.theme import SMALL, Theme

WIDTH, HEIGHT = 11.5, 4.2
HEXAGONAL = 0.16037507477489604  # energy of a hexagonal tiling of area 1, times its cells
HIGHEST = 1.15
NEXT_LEVEL = 1.5  # times the sites; within a level their number changes little


def levels_of(result: dict) -> list[list[dict]]:
    """The iterations of each level, which know their number and energy ratio."""
    area = result["input"]["area"]
    steps = [{**step, "iteration": index + 1, "ratio": step["energy"] * step["sites"] / (HEXAGONAL * area * area)}
             for index, step in enumerate(result["trace"])]
    levels: list[list[dict]] = []
    for step in steps:
        before = levels[-1][0]["sites"] if levels else 0
        if not before / NEXT_LEVEL < step["sites"] < NEXT_LEVEL * before:
            levels.append([])
        levels[-1].append(step)
    return levels


def level_colours(levels: int, theme: Theme) -> list[str]:
    """A colour for each level; blue for the last."""
    others = [theme.purple, theme.vermillion, theme.orange, theme.green, theme.sky]
    return [others[(level - levels) % len(others)] for level in range(1, levels)] + [theme.blue]


def draw_course(axes: Axes, levels: list[list[dict]], key: str, theme: Theme) -> None:
    """The energy ratio of each iteration over its number or its time."""
    for steps, colour in zip(levels, level_colours(len(levels), theme)):
        axes.plot([step[key] for step in steps], [min(step["ratio"], HIGHEST) for step in steps], color=colour,
                  linewidth=1.6, label=count(steps[-1]["sites"], "site"))
    last = levels[-1]
    whole = [step for step in last if step["mesh_vertices"] == last[-1]["mesh_vertices"]]
    axes.plot([step[key] for step in whole], [step["ratio"] for step in whole], color=theme.text, linewidth=2.4,
              label="on the whole surface")
    axes.axhline(1, color=theme.muted, linewidth=1, linestyle=(0, (4, 3)))
    axes.set_xlim(0, 1.02 * last[-1][key])
    axes.grid(True, axis="y")


def draw(result: dict, theme: Theme) -> Figure:
    """Two panels: by iteration, and by time."""
    levels = levels_of(result)
    seconds = result["trace"][-1]["seconds"]
    own = [count(result["options"]["vertices"], "vertex").replace("vertexs", "vertices"),
           count(result["options"]["threads"], "thread") + " used"]
    shown = {**result, "mesh": result["input"]}
    title = f"{PurePath(result['input']['file']).stem}: energy of the sites, level after level"
    interrupted = ["interrupted: the sites are not at rest"] if result["interrupted"] else []
    figure = page(theme, (WIDTH, HEIGHT), title, facts(shown, own), interrupted)
    panels = figure.subplots(1, 2, sharey=True)
    draw_course(panels[0], levels, "iteration", theme)
    draw_course(panels[1], levels, "seconds", theme)
    panels[0].set_ylim(top=HIGHEST)
    panels[0].set_ylabel("energy / energy of a hexagonal tiling")
    panels[0].set_xlabel(f"iteration, of {number(len(result['trace']))}")
    panels[1].set_xlabel(f"seconds since the first iteration began, of {duration(seconds)}")
    panels[1].legend(loc="upper right", fontsize=SMALL)
    return figure


def pictures(_: dict) -> Iterator[tuple[str, Callable[[dict, Theme], Figure]]]:
    """The only picture."""
    yield "", draw
