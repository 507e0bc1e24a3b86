"""The picture of geolloyd profile: kernels by phase, and the course of the relaxation."""

import math
from collections.abc import Callable, Iterator

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, MaxNLocator

from plots.page import (configuration, count, duration, end_labels, interruption, page, scale_axis, single_facts,
                        tick_text)
from plots.result import KERNELS
from plots.theme import SMALL, Theme, on_top_of

WIDTH = 11.5
BAR_HEIGHT = 0.42
COURSE_HEIGHT = 1.75
NARROWEST_NAMED = 0.045  # share of a bar


def name_of(profile: dict) -> str:
    """An engine with its threads."""
    if profile["engine"] == "reference":
        return "reference"
    return f"parallel ({configuration(profile)}, {count(profile['threads'], 'thread')})"


def kernel_colours(theme: Theme) -> dict[str, str]:
    """A colour for each kernel."""
    colours = [theme.blue, theme.orange, theme.green, theme.purple, theme.sky, theme.vermillion, theme.grey]
    return dict(zip(KERNELS, colours))


def draw_bar(axes: Axes, row: int, phase: dict, theme: Theme) -> None:
    """A bar of the shares of a phase's kernels."""
    seconds = phase["kernel_seconds"]
    total = sum(seconds[kernel] for kernel in KERNELS)
    if total == 0:
        axes.text(0.01, row, "no time measured", va="center", fontsize=SMALL, color=theme.muted)
        return
    left = 0.0
    for kernel, colour in kernel_colours(theme).items():
        share = seconds[kernel] / total
        axes.barh(row, share, left=left, height=0.72, color=colour, edgecolor=theme.background, linewidth=0.8)
        if share >= NARROWEST_NAMED:
            axes.text(left + share / 2, row, f"{100 * share:.0f} %", ha="center", va="center", fontsize=SMALL,
                      color=on_top_of(colour))
        left += share


def draw_bars(axes: Axes, profiles: list[dict], theme: Theme) -> None:
    """A bar for each phase of each profile."""
    phases = [(profile, phase) for profile in profiles for phase in profile["phases"]]
    for row, (_, phase) in enumerate(phases):
        draw_bar(axes, row, phase, theme)
    axes.set_yticks(range(len(phases)), [f"{name_of(profile)}\n{phase['phase']} phase, {duration(phase['seconds'])}"
                                         for profile, phase in phases])
    axes.set_xlim(0, 1)
    axes.set_ylim(max(len(phases), 1) - 0.5, -0.5)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda share, _: f"{100 * share:.0f} %"))
    axes.tick_params(axis="y", length=0)
    axes.spines["left"].set_visible(False)
    axes.set_title("share of each kernel in the time of a phase", pad=26)
    used = [kernel for kernel in KERNELS if any(phase["kernel_seconds"][kernel] > 0 for _, phase in phases)]
    colours = kernel_colours(theme)
    if used:
        axes.legend(handles=[Patch(color=colours[kernel], label=KERNELS[kernel]) for kernel in used], ncol=len(used),
                    loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2, borderpad=0, handlelength=1,
                    columnspacing=1.4)


def positive(values: list[float]) -> list[float]:
    """Values with gaps where a logarithmic axis has no place for them."""
    return [value if value > 0 else math.nan for value in values]


def draw_course(axes: Axes, courses: list[tuple[list[float], str, str]], greedy_steps: int, theme: Theme,
                last: bool = False) -> None:
    """Lines over all steps: values, colour and name of each; numbers of steps below the last panel."""
    values = [value for line, _, _ in courses for value in line]
    scale_axis(axes.yaxis, values)
    logarithmic = axes.get_yscale() == "log"
    steps = max(len(line) for line, _, _ in courses)
    axes.set_xlim(0.5, steps + 0.5)
    marker = "o" if steps < 40 else None
    for line, colour, _ in courses:
        axes.plot(range(1, len(line) + 1), positive(line) if logarithmic else line, color=colour, linewidth=1.6,
                  marker=marker, markersize=3.5)
    if 0 < greedy_steps < steps:
        axes.axvline(greedy_steps + 0.5, color=theme.muted, linewidth=1, linestyle=(0, (4, 3)))
    axes.grid(True, axis="y")
    axes.xaxis.set_major_locator(MaxNLocator(10, steps=[1, 2, 5, 10], integer=True))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda step, _: tick_text(step)))
    axes.tick_params(axis="x", labelbottom=last)
    if len(courses) > 1:
        drawn = [(line, colour, name) for line, colour, name in courses if line and line[-1] > 0]
        end_labels(axes, [(len(line), line[-1], name, theme.ink(colour)) for line, colour, name in drawn],
                   0.7 * COURSE_HEIGHT)


def phase_names(axes: Axes, greedy_steps: int, precise_steps: int, theme: Theme) -> None:
    """Says above the topmost course which phases there are, and where."""
    if greedy_steps:
        axes.text(0, 1.02, f"{count(greedy_steps, 'greedy step')}", transform=axes.transAxes, fontsize=SMALL,
                  color=theme.muted)
    if precise_steps:
        axes.text(1, 1.02, f"{count(precise_steps, 'macrostep')} of the precise phase", transform=axes.transAxes,
                  fontsize=SMALL, color=theme.muted, ha="right")


def draw_courses(panels: list[Axes], profiles: list[dict], theme: Theme) -> None:
    """Active regions, energy and time of every step."""
    steps = profiles[0]["steps"]
    greedy_steps = sum(step["phase"] == "greedy" for step in steps)
    last = steps[-1]["energy"]
    energies = [step["energy"] / last if last > 0 else 1 for step in steps]
    draw_course(panels[0], [([step["active_regions"] for step in steps], theme.green, "")], greedy_steps, theme)
    draw_course(panels[1], [(energies, theme.purple, "")], greedy_steps, theme)
    colours = {"reference": theme.orange, "parallel": theme.blue}
    times = [([step["seconds"] for step in profile["steps"]], colours[profile["engine"]], profile["engine"])
             for profile in profiles]
    draw_course(panels[2], times, greedy_steps, theme, last=True)
    if panels[1].get_yscale() == "linear":
        room = 0.08 * (max(energies) - min(energies)) or 0.1
        panels[1].set_ylim(min(energies) - room, max(energies) + room)
    for axes, label in zip(panels, ("active regions", "energy ÷ the last", "time per step (s)")):
        axes.set_ylabel(label, fontsize=SMALL)
    panels[2].set_xlabel("step")
    phase_names(panels[0], greedy_steps, len(steps) - greedy_steps, theme)


def warnings_of(result: dict) -> list[str]:
    """What is wrong with the profiles: interruption, results that differ."""
    differ = len({profile["fingerprint"] for profile in result["profiles"]}) > 1
    return (["× the results of the engines differ"] if differ else []) + interruption(result)


def draw(result: dict, theme: Theme) -> Figure:
    """The whole picture: bars above, courses below."""
    profiles = [profile for profile in result["profiles"] if profile["phases"] or profile["steps"]]
    with_steps = [profile for profile in profiles if profile["steps"]]
    bars_height = 0.95 + BAR_HEIGHT * max(sum(len(profile["phases"]) for profile in profiles), 1)
    heights = [bars_height] + [COURSE_HEIGHT] * (3 if with_steps else 0)
    figure = page(theme, (WIDTH, sum(heights)), "Where the time goes: kernels, phases, steps", single_facts(result),
                  warnings_of(result))
    panels = list(figure.subplots(len(heights), 1, squeeze=False, gridspec_kw={"height_ratios": heights})[:, 0])
    draw_bars(panels[0], profiles, theme)
    if with_steps:
        draw_courses(panels[1:], with_steps, theme)
    return figure


def pictures(result: dict) -> Iterator[tuple[str, Callable]]:
    """What the file's name has after its stem, and who draws it."""
    yield "", draw
