#!/usr/bin/env python3
"""Turns what bench/measure left in a folder into the Markdown tables of bench/README.md."""

import csv
import json
import sys
from pathlib import Path

Row = list[str]


Published = dict[tuple[str, int, str, int], dict[str, float]]


def read_published() -> Published:
    """Seconds by (mesh, triangles, graph, seeds), then by source."""
    table: Published = {}
    lines = (Path(__file__).parent / "published.csv").read_text().splitlines()
    for row in csv.DictReader(line for line in lines if not line.startswith("#")):
        key = (row["mesh"], int(row["triangles"]), row["graph"], int(row["seeds"]))
        table.setdefault(key, {})[row["source"]] = float(row["seconds"])
    return table


def results(folder: Path, pattern: str) -> list[dict]:
    """Complete results, in the order of their folders' names."""
    found = [json.loads(path.read_text()) for path in sorted(folder.glob(pattern))]
    return [result for result in found if not result["interrupted"]]


def print_table(title: str, heads: Row, rows: list[Row]) -> None:
    if not rows:
        return
    print(f"\n{title}\n")
    for row in [heads, ["---"] * len(heads), *rows]:
        print("| " + " | ".join(row) + " |")


def duration(seconds: float | None) -> str:
    if seconds is None:
        return ""
    return f"{seconds:.3g} s" if seconds >= 1 else f"{seconds * 1e3:.3g} ms"


def ratio(numerator: float | None, denominator: float) -> str:
    return "" if numerator is None else f"{numerator / denominator:.3g}"


def percent(share: float) -> str:
    return f"{100 * share:.0f} %"


def mesh_name(result: dict) -> str:
    return Path(result["mesh"]["file"]).stem


def machine_line(result: dict) -> str:
    machine = result["machine"]
    return f"{machine['processor']}, {machine['threads']} threads at once, {machine['compiler']}"


def published_for(published: Published, result: dict, graph: str, seeds: int, source: str) -> float | None:
    key = (mesh_name(result), result["mesh"]["triangles"], graph, seeds)
    return published.get(key, {}).get(source)


def comparison_tables(folder: Path, published: Published) -> None:
    """Reference against parallel, by mesh and graph, beside what is published."""
    rows = []
    for result in results(folder, "compare-*/compare.json"):
        runs = result["runs"]
        regions = [r for r in runs if r["frontier"] == "regions" and r["backend"] == "tbb"]
        if not regions or runs[0]["engine"] != "reference":
            continue
        options, steps = result["options"], result["steps"]
        reference = runs[0]["seconds"]["median"]
        one, most = regions[0], regions[-1]
        best = most["seconds"]["median"]
        graph = options["graph"] + ("-anisotropic" if options["vfield"] else "")
        seeds = options["seeds"]
        given = "given" if options["seeds_file"] else options["init"]
        original = published_for(published, result, graph, seeds, "original") if given == "given" else None
        rows.append([
            f"{mesh_name(result)}, {graph}, {seeds} {given}",
            f"{steps['greedy']}, {steps['macro']}, {steps['micro']}",
            duration(reference),
            duration(one["seconds"]["median"]),
            f"{duration(best)} ({most['threads']})",
            ratio(reference, best),
            f"{most['efficiency']:.2f}" if most["efficiency"] is not None else "",
            f"{most['node_visits_per_second'] * 1e-6:.1f}",
            f"{most['peak_memory_bytes'] * 1e-6:.0f}",
            "equal" if all(r["equal"] for r in runs) else "DIFFERENT",
            duration(original),
            ratio(original, best),
        ])
    print_table(
        "Reference and parallel engine",
        ["mesh, graph, seeds", "steps", "reference", "1 thread", "parallel (threads)", "ratio", "efficiency",
         "M visits/s", "MB", "results", "original", "original / parallel"],
        rows,
    )


def frontier_table(folder: Path) -> None:
    rows = []
    for result in results(folder, "frontiers/compare.json"):
        for run in result["runs"]:
            rows.append([
                run["frontier"] or "reference",
                run["backend"] or "",
                str(run["threads"]),
                duration(run["seconds"]["median"]),
                ratio(run["speedup"], 1),
                "equal" if run["equal"] else "DIFFERENT",
            ])
        title = f"Frontiers and backends, {mesh_name(result)}, {result['options']['seeds']} seeds"
        print_table(title, ["frontier", "backend", "threads", "time", "speed-up", "results"], rows)


def share_in(profile: dict, phase: str) -> tuple[str, str]:
    for part in profile["phases"]:
        if part["phase"] == phase:
            return duration(part["seconds"]), percent(part["search_share"])
    return "", ""


def ladder_table(folder: Path, published: Published) -> None:
    """Both engines by number of seeds, and Dijkstra's share."""
    rows = []
    found = results(folder, "profile-*/profile.json")
    for result in sorted(found, key=lambda r: r["options"]["seeds"]):
        reference, parallel = result["profiles"]
        seeds = result["options"]["seeds"]
        thesis = published_for(published, result, result["options"]["graph"], seeds, "thesis")
        cells = [str(seeds), duration(reference["seconds"]), duration(parallel["seconds"]),
                 ratio(reference["seconds"], parallel["seconds"])]
        for profile in (reference, parallel):
            for phase in ("greedy", "precise"):
                cells.append(" ".join(share_in(profile, phase)))
        cells.append(duration(thesis))
        cells.append(ratio(thesis, parallel["seconds"]))
        rows.append(cells)
    if found:
        title = f"By number of random seeds, {mesh_name(found[0])}, single runs; times of phases, and Dijkstra's share in them"
        print_table(title, ["seeds", "reference", "parallel", "ratio", "reference, greedy", "precise",
                            "parallel, greedy", "precise", "thesis", "thesis / parallel"], rows)


def batch_table(folder: Path, published: Published) -> None:
    """The plane, both engines."""
    by_key: dict[tuple[str, int], list] = {}
    for result in results(folder, "batch-plane-*/batch.json"):
        for row in result["rows"]:
            cells = by_key.setdefault((row["graph"], row["seeds"]), [None, None, None])
            cells[0 if result["options"]["engine"] == "reference" else 1] = row["seconds"]["avg"]
            cells[2] = published_for(published, result, row["graph"], row["seeds"], "thesis")
    rows = [
        [graph, str(seeds), duration(reference), duration(parallel), ratio(reference, parallel),
         duration(thesis), ratio(thesis, parallel)]
        for (graph, seeds), (reference, parallel, thesis) in by_key.items()
        if reference and parallel
    ]
    print_table("The plane, means of three batches of random seeds",
                ["graph", "seeds", "reference", "parallel", "ratio", "thesis", "thesis / parallel"], rows)


def stage_of(name: str) -> tuple[str, str, str]:
    """What is timed, by how many threads, with which bucket width ("": the default)."""
    parts = name.removesuffix("/manual_time").split("/")
    delta = parts.pop().removeprefix("delta:") if parts[-1].startswith("delta:") else ""
    threads = parts.pop().removeprefix("threads:")
    mesh = next(i for i, part in enumerate(parts) if i > 0 and ("." in part or "creature-" in part))
    del parts[mesh]
    return "/".join(parts), threads, delta


def throughput(benchmark: dict) -> str:
    for key in ("triangles/s", "node visits/s", "arcs/s", "nodes/s", "seeds/s"):
        if key in benchmark:
            return f"{benchmark[key] * 1e-6:.3g} M {key}"
    return ""


def stage_tables(folder: Path) -> None:
    """What Google Benchmark measured: each stage by threads, and the sweep of bucket widths."""
    path = folder / "stages.json"
    if not path.is_file():
        return
    stages: dict[str, dict[str, dict]] = {}
    sweep: dict[tuple[str, str], dict[str, float]] = {}
    for benchmark in json.loads(path.read_text())["benchmarks"]:
        stage, threads, delta = stage_of(benchmark["run_name"])
        if delta:
            sweep.setdefault((stage, threads), {})[delta] = benchmark["real_time"]
        else:
            stages.setdefault(stage, {})[threads] = benchmark
    threads = sorted({t for by in stages.values() for t in by if t != "sequential"}, key=int)
    rows = [
        [stage, *(duration(by[t]["real_time"] / 1e3) if t in by else "" for t in ("sequential", *threads)),
         throughput(list(by.values())[-1])]
        for stage, by in stages.items()
    ]
    heads = ["stage", "sequential", *(f"{t} thread{'' if t == '1' else 's'}" for t in threads), "throughput of the last"]
    print_table("Stages", heads, rows)
    widths = sorted({d for by in sweep.values() for d in by}, key=float)
    rows = [
        [stage, t, *(duration(by[d] / 1e3) if d in by else "" for d in widths)] for (stage, t), by in sweep.items()
    ]
    print_table("Delta-stepping by width of buckets, in mean arcs", ["search", "threads", *widths], rows)


def main() -> int:
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        print("usage: tables.py FOLDER, one that bench/measure has filled", file=sys.stderr)
        return 2
    folder = Path(sys.argv[1])
    published = read_published()
    for result in results(folder, "*/*.json")[:1]:
        print(machine_line(result))
    comparison_tables(folder, published)
    frontier_table(folder)
    ladder_table(folder, published)
    batch_table(folder, published)
    stage_tables(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
