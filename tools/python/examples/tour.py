"""A tour of the package, cell by cell: `tour.py [FOLDER [TRIANGLES]]` draws its pictures into the folder."""
# %% A mesh: vertices (n, 3) and faces (m, 3). One of your own comes from geolloyd.read("scan.ply").
import pathlib
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")  # leave this out in a notebook
import matplotlib.pyplot as plt  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

import geolloyd  # noqa: E402

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
mesh = geolloyd.generate("creature", int(sys.argv[2]) if len(sys.argv) > 2 else 20_000)
print(mesh)


# %% How the pictures are made: each face in one colour, darker where it faces away from the light.
def draw(axes, vertices, faces, colors, title, edges="none"):
    corners = vertices[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-300
    light = 0.45 + 0.55 * np.clip(normals @ np.array([0.4, -0.5, 0.77]), 0, 1)
    rgb = np.broadcast_to(colors, (len(faces), 3)) * light[:, None]
    axes.add_collection3d(Poly3DCollection(corners, facecolors=rgb, edgecolors=edges, linewidths=0.3))
    middle, half = (vertices.max(0) + vertices.min(0)) / 2, np.ptp(vertices, 0).max() / 2.4
    for set_limits, m in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), middle):
        set_limits(m - half, m + half)
    axes.set_box_aspect((1, 1, 1), zoom=1.5)
    axes.view_init(20, -60)
    axes.set_axis_off()
    axes.set_title(title, y=0.9)


def draw_pair(name, *pictures):
    figure = plt.figure(figsize=(10, 5))
    for i, (vertices, faces, colors, title, edges) in enumerate(pictures):
        draw(figure.add_subplot(1, 2, i + 1, projection="3d"), vertices, faces, colors, title, edges)
    figure.tight_layout()
    figure.savefig(folder / name, dpi=90)
    plt.close(figure)


GREY = np.array([0.75, 0.77, 0.8])

# %% A remesh: 600 vertices, nearly all with six neighbours.
remesh = geolloyd.remesh(mesh, 600)
judged = geolloyd.quality(remesh, original=mesh, samples=50_000)
print(remesh, f"valence 6: {100 * judged['quality']['share_valence_6']:.0f} %,",
      f"mean distance: {judged['likeness']['two_sided']['mean']:.2g}")
draw_pair("remesh.png", (*mesh, GREY, f"{len(mesh.faces)} faces", "none"), (*remesh, GREY, f"{len(remesh.faces)} faces", "black"))

# %% Values go along: each vertex of the remesh stands for a point of the input.
height = mesh.vertices[:, 2]
carried = (height[mesh.faces[remesh.triangle]] * remesh.barycentric).sum(1)
print("largest difference of a height:", abs(carried - remesh.vertices[:, 2]).max())

# %% Regions: a centroidal Voronoi tessellation of the graph of edges, and its dual.
regions = geolloyd.relax(mesh, 120)
dual = regions.dual()
print(regions, dual)
palette = plt.get_cmap("tab20")(np.arange(len(regions.seeds)) * 7 % 20)[:, :3]
draw_pair("regions.png", (*mesh, palette[regions.region[mesh.faces[:, 0]]], f"{len(regions.seeds)} regions", "none"),
          (*dual, GREY, "their dual", "black"))

# %% Distances from one vertex, along the surface; and finer triangles where it is curved.
far = geolloyd.distances(mesh, [int(np.argmin(mesh.vertices[:, 0]))], graph="vertex-far")
rings = plt.get_cmap("viridis")(far[mesh.faces].mean(1) / far.max())[:, :3]
rings[(far[mesh.faces].mean(1) * 20 / far.max()).astype(int) % 2 == 1] *= 0.8
adapted = geolloyd.remesh(mesh, 600, adapt=1)
draw_pair("distances.png", (*mesh, rings, "distance from a vertex", "none"), (*adapted, GREY, "adapted to curvature", "black"))

# %% How the energy falls, from different first seeds.
figure, axes = plt.subplots(figsize=(6, 3.5))
for init in ("random", "farthest", "surface"):
    trace = geolloyd.relax(mesh, 120, init=init, greedy="off").trace
    axes.plot([step["energy"] for step in trace], label=init)
axes.set(xlabel="step", ylabel="energy", yscale="log")
axes.legend()
figure.tight_layout()
figure.savefig(folder / "energy.png", dpi=90)
