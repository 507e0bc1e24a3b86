"""Colours and type, for light pages and for dark ones. Colours of data: Okabe and Ito's, lightened on dark."""

from contextlib import AbstractContextManager
from dataclasses import dataclass

import matplotlib
from matplotlib.colors import to_hex, to_rgb

SMALL, NORMAL, TITLE = 9, 10, 14


@dataclass(frozen=True)
class Theme:
    """The colours of a variant, and what its files' names end with."""

    suffix: str
    background: str
    text: str
    muted: str
    grid: str
    alarm: str
    blue: str
    orange: str
    green: str
    purple: str
    sky: str
    vermillion: str
    grey: str

    def applied(self) -> AbstractContextManager:
        """A context in which matplotlib draws in this theme."""
        return matplotlib.rc_context({
            "font.family": "DejaVu Sans", "font.size": NORMAL, "text.parse_math": False,
            "axes.titlesize": NORMAL, "axes.labelsize": NORMAL, "axes.titlelocation": "left",
            "xtick.labelsize": SMALL, "ytick.labelsize": SMALL, "legend.fontsize": SMALL, "legend.frameon": False,
            "figure.facecolor": self.background, "axes.facecolor": self.background,
            "savefig.facecolor": self.background, "text.color": self.text, "axes.labelcolor": self.text,
            "axes.titlecolor": self.text, "xtick.color": self.text, "ytick.color": self.text,
            "axes.edgecolor": self.muted, "grid.color": self.grid, "grid.linewidth": 0.7, "axes.axisbelow": True,
            "axes.spines.top": False, "axes.spines.right": False,
        })

    def ink(self, colour: str) -> str:
        """A colour of data, nearer to that of text, for words."""
        return to_hex([0.55 * c + 0.45 * t for c, t in zip(to_rgb(colour), to_rgb(self.text))])

    def faint(self, colour: str) -> str:
        """A colour of data, nearer to the background, for areas."""
        return to_hex([0.22 * c + 0.78 * b for c, b in zip(to_rgb(colour), to_rgb(self.background))])


def on_top_of(colour: str) -> str:
    """Black or white, whichever is read more easily on a colour."""
    red, green, blue = to_rgb(colour)
    return "#000000" if 0.299 * red + 0.587 * green + 0.114 * blue > 0.5 else "#ffffff"


LIGHT = Theme(
    suffix="", background="#ffffff", text="#1f2328", muted="#6e7781", grid="#e1e4e8", alarm="#d1001f",
    blue="#0072b2", orange="#e69f00", green="#009e73", purple="#cc79a7", sky="#56b4e9", vermillion="#d55e00",
    grey="#9aa1a9",
)
DARK = Theme(
    suffix="-dark", background="#0d1117", text="#e6edf3", muted="#8b949e", grid="#272d35", alarm="#ff5c5c",
    blue="#3d9be0", orange="#f0b429", green="#1db88d", purple="#de93bc", sky="#9ad7f7", vermillion="#e8672b",
    grey="#7d8590",
)
THEMES = [LIGHT, DARK]
